#include "FileWatch.h"

#include <cmath>
#include <filesystem>

namespace osgFbrdf {
namespace {

constexpr double kInterval = 1.0;  // seconds: soon enough for a person, seldom enough for a disc

}  // namespace

bool FileWatch::look(Stamp& stamp) const
{
    std::error_code timeError, sizeError;
    stamp = {std::filesystem::last_write_time(path_, timeError).time_since_epoch().count(),
             std::filesystem::file_size(path_, sizeError)};
    return !timeError && !sizeError;
}

void FileWatch::follow(const std::string& path)
{
    path_ = path;
    looked_ = -1e30;
    if (path_.empty() || !look(seen_)) seen_ = {0, 0};
}

bool FileWatch::changed(double seconds)
{
    if (path_.empty() || std::abs(seconds - looked_) < kInterval) return false;
    looked_ = seconds;
    Stamp stamp;
    if (!look(stamp) || stamp == seen_) return false;
    seen_ = stamp;
    return true;
}

}  // namespace osgFbrdf
