// FileWatch.h - whether a file is another one than a second ago.
#pragma once
#include <cstdint>
#include <string>
#include <utility>

namespace osgFbrdf {

class FileWatch {
public:
    /// From now on; what the file is now is known. Empty: nothing ever changes.
    void follow(const std::string& path);
    const std::string& path() const { return path_; }
    /// Looks at most once a second of `seconds`; true when time of writing or size differ from
    /// what was seen last. A file that is not there has not changed: it may be being replaced.
    bool changed(double seconds);

private:
    using Stamp = std::pair<int64_t, uintmax_t>;
    bool look(Stamp& stamp) const;

    std::string path_;
    Stamp seen_{0, 0};
    double looked_ = -1e30;
};

}  // namespace osgFbrdf
