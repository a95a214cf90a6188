// OutputFileTest.cpp - files appear complete or not at all, and only where a file belongs.
#include "support/ExpectError.h"
#include "support/FileBytes.h"
#include "support/FileSizeLimit.h"
#include "support/TemporaryDir.h"

#include <fbrdf/base/OutputFile.h>
#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>
#include <atomic>
#include <csignal>
#include <filesystem>
#include <thread>

namespace fbrdf {
namespace {

namespace fs = std::filesystem;
using test::expectError;
using test::fileBytes;
using test::putFile;
using test::TemporaryDir;
using Names = std::vector<std::string>;

unsigned int modeOf(const std::string& path)
{
    struct stat info {};
    EXPECT_EQ(::stat(path.c_str(), &info), 0) << path;
    return info.st_mode & 07777u;
}

class OutputFileTest : public testing::Test {
protected:
    std::string path(const std::string& name) const { return folder_.file(name); }

    void expectRefused(const std::string& target, const std::string& words) const
    {
        const Names before = folder_.names();
        expectError(ErrorKind::output, words, [&] { writeFile(target, "x"); });
        expectError(ErrorKind::output, words, [&] { requireWritable(target); });
        expectError(ErrorKind::output, words, [&] { OutputFiles().add(target, "x"); });
        EXPECT_EQ(folder_.names(), before);
    }

    TemporaryDir folder_;
};

TEST_F(OutputFileTest, AppearsOnCommit)
{
    OutputFile file(path("a"));
    file.write("one ");
    EXPECT_FALSE(fs::exists(path("a")));
    file.write(std::string("two\0", 4));
    file.commit();
    EXPECT_EQ(fileBytes(path("a")), std::string("one two\0", 8));
    EXPECT_EQ(folder_.names(), Names{"a"});
}

TEST_F(OutputFileTest, WithoutCommitNothingRemains)
{
    putFile(path("a"), "old");
    {
        OutputFile file(path("a"));
        file.write("new");
        file.close();
        EXPECT_EQ(folder_.names(), Names{"a"});
    }
    EXPECT_EQ(fileBytes(path("a")), "old");
    EXPECT_EQ(folder_.names(), Names{"a"});
}

// As one that a user or the system ends does.
TEST_F(OutputFileTest, AKilledProcessLeavesNothing)
{
    const int probe = ::open(path("").c_str(), O_TMPFILE | O_WRONLY, 0600);
    if (probe < 0) GTEST_SKIP() << "the file system knows no files without names";
    ::close(probe);
    putFile(path("a"), "old");
    for (const int signal : {SIGINT, SIGTERM, SIGKILL}) {
        const pid_t child = ::fork();
        if (child == 0) {
            OutputFiles files;
            for (const char* name : {"a", "b"}) files.add(path(name), std::string(100000, 'x'));
            ::raise(signal);
        }
        int status = 0;
        ASSERT_EQ(::waitpid(child, &status, 0), child);
        EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal);
        EXPECT_EQ(fileBytes(path("a")), "old");
        EXPECT_EQ(folder_.names(), Names{"a"});
    }
}

TEST_F(OutputFileTest, NamesThatAreTakenArePassedOver)
{
    putFile(path("a"), "old");  // a new file gets its name at once
    putFile(path("precious"), "kept");
    fs::create_symlink("precious", path("a.part0"));  // planted, or left by a process that died
    fs::create_directory(path("a.part1"));
    writeFile(path("a"), "new");
    EXPECT_EQ(fileBytes(path("a")), "new");
    EXPECT_EQ(fileBytes(path("precious")), "kept");
    EXPECT_EQ(folder_.names(), (Names{"a", "a.part0", "a.part1", "precious"}));
}

// Ranks of one program may have equal process ids in containers, so threads must do as well.
TEST_F(OutputFileTest, WritersOfOnePathDoNotMeet)
{
    std::atomic<int> failures{0};
    std::vector<std::thread> writers;
    for (char c = 'a'; c < 'e'; ++c)
        writers.emplace_back([&, c] {
            for (int i = 0; i < 50; ++i) try {
                    writeFile(path("file"), std::string(9999, c));
                } catch (const Error&) {
                    ++failures;
                }
        });
    for (std::thread& writer : writers) writer.join();
    EXPECT_EQ(failures, 0);
    const std::string bytes = fileBytes(path("file"));
    EXPECT_EQ(bytes, std::string(9999, bytes.at(0)));
    EXPECT_EQ(folder_.names(), Names{"file"});
}

TEST_F(OutputFileTest, LongestNamesAreNames)
{
    const std::string ascii(255, 'n');  // NAME_MAX
    std::string accents;
    for (int i = 0; i < 127; ++i) accents += "\xC3\xA9";
    for (const std::string& name : {ascii, accents, "n" + accents})
        for (const char* bytes : {"new", "replaced"}) {
            writeFile(path(name), bytes);
            EXPECT_EQ(fileBytes(path(name)), bytes);
        }
    EXPECT_EQ(folder_.names().size(), 3u);
}

TEST_F(OutputFileTest, LinksAreFollowedAndStay)
{
    fs::create_directory(path("sub"));
    putFile(path("sub/real"), "old");
    fs::create_symlink("sub/real", path("link"));
    fs::create_symlink(path("link"), path("sub/again"));
    writeFile(path("sub/again"), "new");
    EXPECT_TRUE(fs::is_symlink(path("link")));
    EXPECT_TRUE(fs::is_symlink(path("sub/again")));
    EXPECT_EQ(fileBytes(path("sub/real")), "new");
}

TEST_F(OutputFileTest, ALinkToNothingYetMakesWhatItNames)
{
    fs::create_symlink("later", path("link"));
    writeFile(path("link"), "new");
    EXPECT_EQ(fs::read_symlink(path("link")), "later");
    EXPECT_EQ(fileBytes(path("later")), "new");
    fs::create_symlink("absent/later", path("lost"));
    expectRefused(path("lost"), "No such file or directory");
}

TEST_F(OutputFileTest, LinksInACircleAreRefused)
{
    fs::create_symlink("b", path("a"));
    fs::create_symlink("a", path("b"));
    expectRefused(path("a"), "Too many levels of symbolic links");
}

TEST_F(OutputFileTest, WhatIsNoFileIsRefusedAndStays)
{
    fs::create_directory(path("folder"));
    ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0666), 0);
    fs::create_symlink("/dev/null", path("link"));
    expectRefused(path("folder"), "found a folder, expected a file or nothing");
    expectRefused(path("pipe"), "found a pipe, expected a file or nothing");
    expectRefused("/dev/null", "found a device, expected a file or nothing");
    expectRefused(path("link"), "found a device, expected a file or nothing");
    expectRefused("", "found an empty path");
    EXPECT_TRUE(fs::is_fifo(path("pipe")));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(OutputFileTest, SocketsAreRefused)
{
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path("s").copy(address.sun_path, sizeof address.sun_path - 1);
    const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
    ASSERT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    expectRefused(path("s"), "found a socket, expected a file or nothing");
    ::close(socket);
}

// "--stats /dev/stdout > log": a rename would put the new file in the place of the log.
TEST_F(OutputFileTest, OpenStreamsAreRefused)
{
    const int stream = ::open(path("log").c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0666);
    ASSERT_GE(stream, 0);
    for (const char* folder : {"/dev/fd/", "/proc/self/fd/"})
        expectRefused(folder + std::to_string(stream), "found a stream that is open already");
    fs::create_symlink("/dev/fd/" + std::to_string(stream), path("link"));
    expectRefused(path("link"), "found a stream that is open already");
    ::close(stream);
}

TEST_F(OutputFileTest, PlacesThatTakeNoFileSayWhy)
{
    putFile(path("file"), "");
    expectRefused(path("absent/a"), "cannot be written: No such file or directory");
    expectRefused(path("file/a"), "cannot be written: Not a directory");
    expectRefused("/proc/fbrdf-cannot-be-here", "cannot be written");
    expectError(ErrorKind::output, path("absent/a") + ": ",
                [&] { writeFile(path("absent/a"), "x"); });
}

TEST_F(OutputFileTest, NewFilesGetWhatTheUmaskAllows)
{
    const mode_t before = ::umask(027);
    writeFile(path("a"), "x");
    ::umask(before);
    EXPECT_EQ(modeOf(path("a")), 0640u);
}

TEST_F(OutputFileTest, ReplacedFilesKeepTheirMode)
{
    for (const mode_t mode : {0600u, 0666u, 0755u, 0604u}) {
        putFile(path("a"), "old");
        ASSERT_EQ(::chmod(path("a").c_str(), mode), 0);
        writeFile(path("a"), "new");
        EXPECT_EQ(modeOf(path("a")), mode);
        EXPECT_EQ(fileBytes(path("a")), "new");
    }
}

/// The rights of the user "nobody", for tests that may run as root.
class Nobody {
public:
    Nobody() : before_(::geteuid()) { good_ = before_ != 0 || ::seteuid(65534) == 0; }
    ~Nobody() { good_ = ::seteuid(before_) == 0; }
    Nobody(const Nobody&) = delete;
    Nobody& operator=(const Nobody&) = delete;
    bool good() const { return good_; }

private:
    uid_t before_;
    bool good_ = false;
};

TEST_F(OutputFileTest, FilesThatAreReadOnlyAreNotReplaced)
{
    putFile(path("a"), "old");
    ASSERT_EQ(::chmod(path("a").c_str(), 0444), 0);
    ASSERT_EQ(::chmod(path("").c_str(), 0777), 0);
    const Nobody user;
    ASSERT_TRUE(user.good());
    expectRefused(path("a"), "cannot be written: Permission denied");
    EXPECT_EQ(fileBytes(path("a")), "old");
}

TEST_F(OutputFileTest, AFullDiskLeavesNothingAndKeepsTheOldFile)
{
    putFile(path("a"), "old");
    const std::string bytes(100000, 'x');  // beyond what a stream buffers
    for (const rlim_t limit : std::initializer_list<rlim_t>{0, 1, 5000, 99999}) {
        const test::FileSizeLimit full(limit);
        for (const std::string& content : {bytes, bytes.substr(0, limit + 1)})
            expectError(ErrorKind::output, path("a") + ": cannot be written: File too large",
                        [&] { writeFile(path("a"), content); });
    }
    EXPECT_EQ(fileBytes(path("a")), "old");
    EXPECT_EQ(folder_.names(), Names{"a"});
}

TEST_F(OutputFileTest, ATargetThatBecomesAFolderIsAnError)
{
    {
        OutputFile file(path("a"));
        fs::create_directory(path("a"));
        expectError(ErrorKind::output, path("a") + ": cannot be written: Is a directory",
                    [&] { file.commit(); });
    }
    EXPECT_EQ(folder_.names(), Names{"a"});
}

TEST_F(OutputFileTest, SeveralAppearTogether)
{
    OutputFiles files;
    files.add(path("a"), "one");
    files.add(path("b"), "two");
    files.add(path("a"), "three");  // of one name the last one stays
    EXPECT_FALSE(fs::exists(path("a")));
    files.commit();
    EXPECT_EQ(fileBytes(path("a")), "three");
    EXPECT_EQ(fileBytes(path("b")), "two");
    EXPECT_EQ(folder_.names(), (Names{"a", "b"}));
}

TEST_F(OutputFileTest, WhereOneOfSeveralFailsNoneAppears)
{
    {
        OutputFiles files;
        files.add(path("a"), "small");
        files.add(path("b"), "larger than the disk");
        const test::FileSizeLimit full(10);
        expectError(ErrorKind::output, path("b"), [&] { files.commit(); });
    }
    EXPECT_TRUE(folder_.names().empty());
}

TEST_F(OutputFileTest, AskingLeavesNothing)
{
    putFile(path("a"), "old");
    requireWritable(path("a"));
    requireWritable(path("b"));
    EXPECT_EQ(fileBytes(path("a")), "old");
    EXPECT_EQ(folder_.names(), Names{"a"});
}

}  // namespace
}  // namespace fbrdf
