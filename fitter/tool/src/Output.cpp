#include "Output.h"

#include <fbrdf/base/Error.h>

#include <unistd.h>
#include <cerrno>

namespace fbrdf::tool {
namespace {

/// False with errno set when not all of it could be written.
bool writeAll(int descriptor, std::string_view text)
{
    while (!text.empty()) {
        const ssize_t written = ::write(descriptor, text.data(), text.size());
        if (written < 0 && errno != EINTR) return false;
        if (written > 0) text.remove_prefix(static_cast<size_t>(written));
    }
    return true;
}

}  // namespace

void writeOut(std::string_view text)
{
    if (!writeAll(STDOUT_FILENO, text))
        throw Error(ErrorKind::output, "standard output",
                    "cannot be written: " + systemErrorText(errno));
}

std::string oneLine(std::string text)
{
    for (char& c : text)
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
    return text;
}

}  // namespace fbrdf::tool
