// FileWatch.h - finds out whether a file has changed since it was last looked at.
#pragma once
#include <cstdint>
#include <string>
#include <utility>

namespace osgFbrdf {

class FileWatch {
public:
    /// Watches the file from now on: the present content is not a change. Empty: nothing changes.
    void follow(const std::string& path);
    const std::string& path() const { return path_; }
    /// Looks at most once a second of the clock that `seconds` comes from. True when the time of
    /// writing or the size differ from those seen last. A file that is not there has not changed:
    /// it may be about to be replaced.
    bool changed(double seconds);

private:
    using Stamp = std::pair<int64_t, uintmax_t>;
    bool look(Stamp& stamp) const;

    std::string path_;
    Stamp seen_{0, 0};
    double looked_ = -1e30;
};

}  // namespace osgFbrdf
