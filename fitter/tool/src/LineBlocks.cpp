#include "LineBlocks.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>

namespace fbrdf::tool {
namespace {

constexpr size_t kBlockBytes = size_t(1) << 20;  // about 15,000 pairs: 10 ms of work for a thread
constexpr size_t kReadBytes = size_t(1) << 18;

}  // namespace

LineBlocks::LineBlocks(const std::string& path)
    : name_(path == "-" ? "standard input" : path),
      descriptor_(path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC))
{
    struct stat status {};
    if (descriptor_ < 0 || ::fstat(descriptor_, &status) != 0)
        throw Error(ErrorKind::input, name_, "cannot be read: " + systemErrorText(errno));
    if (S_ISREG(status.st_mode)) size_ = static_cast<uint64_t>(status.st_size);
}

LineBlocks::~LineBlocks()
{
    if (descriptor_ != STDIN_FILENO && descriptor_ >= 0) ::close(descriptor_);
}

bool LineBlocks::mustWait() const
{
    pollfd asked{descriptor_, POLLIN, 0};
    return ::poll(&asked, 1, 0) == 0;
}

bool LineBlocks::readMore(std::string& text)
{
    bytes_.resize(kReadBytes);
    ssize_t count = 0;
    do {
        count = ::read(descriptor_, bytes_.data(), kReadBytes);
    } while (count < 0 && errno == EINTR);
    if (count < 0)
        throw Error(ErrorKind::input, name_, "cannot be read: " + systemErrorText(errno));
    bytesRead_ += static_cast<uint64_t>(count);
    if (count > 0)
        decoder_.append({bytes_.data(), static_cast<size_t>(count)}, text);
    else
        decoder_.finish(text);
    return count > 0;
}

bool LineBlocks::next(LineBlock& block)
{
    block.text.swap(rest_);
    rest_.clear();
    block.firstLine = line_;
    size_t end = std::string::npos;  // of the last whole line
    while (!ended_ &&
           (end == std::string::npos || (block.text.size() < kBlockBytes && !mustWait()))) {
        if (end == std::string::npos && block.text.size() > kBlockBytes)
            throw Error(ErrorKind::input, where(line_),
                        Found("a line longer than a megabyte").expected("numbers"));
        ended_ = !readMore(block.text);
        end = block.text.rfind('\n');
    }
    if (!ended_) {
        rest_.assign(block.text, end + 1);
        block.text.resize(end + 1);
    }
    line_ += static_cast<size_t>(std::count(block.text.begin(), block.text.end(), '\n'));
    return !block.text.empty();
}

}  // namespace fbrdf::tool
