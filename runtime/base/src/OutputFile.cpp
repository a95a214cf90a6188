#include <fbrdf/base/OutputFile.h>

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <filesystem>

namespace fbrdf {
namespace {

namespace fs = std::filesystem;

// What may be at a path that is written to.
constexpr const char* kExpected = "a file or nothing";
// Links that may follow one another; Linux gives up after as many.
constexpr int kMaxLinks = 40;
// Temporary names that may be taken already.
constexpr int kMaxTemporaries = 1000;
// Most bytes of a target's name that its temporary one repeats. File systems allow 255 in all.
constexpr size_t kMaxRepeated = 200;

[[noreturn]] void refuse(const std::string& path, const std::string& what)
{
    throw Error(ErrorKind::output, path, what);
}

[[noreturn]] void failWith(const std::string& path, int number)
{
    refuse(path, "cannot be written: " + systemErrorText(number));
}

// /proc/self/fd/1, to which /dev/stdout leads, looks like a link to the file that the stream writes
// to; a rename would take that file away from the stream.
bool isOpenStream(const fs::path& link)
{
    std::error_code ignored;
    return fs::equivalent(link.parent_path(), "/dev/fd", ignored);
}

// Where the bytes go in the end. fs::canonical would not follow a link to a file yet to be made.
std::string followed(const std::string& path)
{
    fs::path target = path;
    std::error_code error;
    for (int i = 0; i < kMaxLinks; ++i) {
        if (!fs::is_symlink(fs::symlink_status(target, error))) return target.string();
        if (isOpenStream(target))
            refuse(path, Found("a stream that is open already").expected(kExpected));
        target = target.parent_path() / fs::read_symlink(target, error);
        if (error) failWith(path, error.value());
    }
    failWith(path, ELOOP);
}

const char* nameOf(mode_t mode)
{
    if (S_ISDIR(mode)) return "a folder";
    if (S_ISFIFO(mode)) return "a pipe";
    if (S_ISSOCK(mode)) return "a socket";
    return "a device";
}

// Permissions of the file that is there, or -1. Refuses what must not be replaced.
int modeToKeep(const std::string& target, const std::string& path)
{
    struct stat info {};
    if (::stat(target.c_str(), &info) != 0) return -1;
    if (!S_ISREG(info.st_mode)) refuse(path, Found(nameOf(info.st_mode)).expected(kExpected));
    if (::faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0) failWith(path, errno);
    return static_cast<int>(info.st_mode & 07777);
}

// Long names are cut, at the beginning of a character of UTF-8.
std::string shortened(std::string name)
{
    if (name.size() <= kMaxRepeated) return name;
    size_t size = kMaxRepeated;
    while (size > 0 && (static_cast<unsigned char>(name[size]) & 0xc0) == 0x80) --size;
    name.resize(size);
    return name;
}

// In the target's folder, because a rename cannot cross file systems.
std::string temporaryName(const std::string& target, int attempt)
{
    const fs::path file(target);
    return (file.parent_path() /
            (shortened(file.filename().string()) + ".part" + std::to_string(attempt)))
        .string();
}

// An open descriptor. O_EXCL: a name that is taken is somebody else's, and may be a link to
// anywhere. With mode 0666 the umask decides, as for any other output file.
int createTemporary(const std::string& target, std::string& temporary)
{
    for (int i = 0; i < kMaxTemporaries; ++i) {
        temporary = temporaryName(target, i);
        const int file = ::open(temporary.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
        if (file >= 0 || errno != EEXIST) return file;
    }
    return -1;
}

// Descriptor of a file without a name in the target's folder, which vanishes with the process; -1
// where there is none: the file system may know none, and giving it a name takes /proc.
int createUnnamed(const std::string& target)
{
    constexpr const char* kOpenFiles = "/proc/self/fd";
    const std::string parent = fs::path(target).parent_path().string();
    if (::access(kOpenFiles, X_OK) != 0) return -1;
    return ::open(parent.empty() ? "." : parent.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
}

// False with errno set where the name is taken or cannot be given.
bool giveName(int descriptor, const std::string& name)
{
    const std::string file = "/proc/self/fd/" + std::to_string(descriptor);
    return ::linkat(AT_FDCWD, file.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

// A temporary name of the target, or empty with errno set.
std::string giveTemporaryName(int descriptor, const std::string& target)
{
    for (int i = 0; i < kMaxTemporaries; ++i) {
        const std::string name = temporaryName(target, i);
        if (giveName(descriptor, name)) return name;
        if (errno != EEXIST) break;
    }
    return "";
}

// A buffered stream on the descriptor, or null with errno set and the descriptor closed.
std::FILE* streamOf(int descriptor, int mode)
{
    std::FILE* stream = nullptr;
    if (mode < 0 || ::fchmod(descriptor, static_cast<mode_t>(mode)) == 0)
        stream = ::fdopen(descriptor, "wb");
    const int number = errno;
    if (!stream) ::close(descriptor);
    errno = number;
    return stream;
}

}  // namespace

OutputFile::OutputFile(const std::string& path) : path_(path)
{
    if (path.empty()) refuse("output", Found("an empty path").expected("the path of a file"));
    target_ = followed(path);
    const int mode = modeToKeep(target_, path);
    unnamed_ = createUnnamed(target_);
    const int descriptor = unnamed_ >= 0 ? ::fcntl(unnamed_, F_DUPFD_CLOEXEC, 0)
                                         : createTemporary(target_, temporary_);
    if (descriptor >= 0) file_ = streamOf(descriptor, mode);
    if (file_) return;
    const int number = errno;
    if (descriptor >= 0 && !temporary_.empty()) std::remove(temporary_.c_str());
    if (unnamed_ >= 0) ::close(unnamed_);
    failWith(path, number);
}

OutputFile::~OutputFile()
{
    if (file_) std::fclose(file_);
    if (unnamed_ >= 0) ::close(unnamed_);
    if (!temporary_.empty()) std::remove(temporary_.c_str());
}

void OutputFile::write(std::string_view bytes)
{
    FBRDF_ASSERT(file_, !=, nullptr);
    if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) failWith(path_, errno);
}

void OutputFile::close()
{
    if (!file_) return;
    std::FILE* file = file_;
    file_ = nullptr;
    if (std::fclose(file) != 0) failWith(path_, errno);
}

void OutputFile::commit()
{
    FBRDF_ASSERT(unnamed_ >= 0 || !temporary_.empty(), ==, true);
    close();
    if (unnamed_ >= 0) place();
    if (temporary_.empty()) return;
    if (std::rename(temporary_.c_str(), target_.c_str()) != 0) failWith(path_, errno);
    temporary_.clear();
}

// Names the file, by a temporary name where the path is taken.
void OutputFile::place()
{
    if (!giveName(unnamed_, target_)) {
        if (errno != EEXIST) failWith(path_, errno);
        temporary_ = giveTemporaryName(unnamed_, target_);
        if (temporary_.empty()) failWith(path_, errno);
    }
    ::close(unnamed_);
    unnamed_ = -1;
}

void OutputFiles::add(const std::string& path, std::string_view bytes)
{
    files_.emplace_back(path).write(bytes);
}

void OutputFiles::commit()
{
    for (OutputFile& file : files_) file.close();
    for (OutputFile& file : files_) file.commit();
    files_.clear();
}

void writeFile(const std::string& path, std::string_view bytes)
{
    OutputFile file(path);
    file.write(bytes);
    file.commit();
}

void requireWritable(const std::string& path)
{
    const OutputFile probe(path);
}

}  // namespace fbrdf
