// TemporaryDir.h - a new folder for the files of one test, removed at the end with all its files.
#pragma once
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace fbrdf::test {

class TemporaryDir {
public:
    TemporaryDir()
    {
        std::string pattern = (std::filesystem::temp_directory_path() / "fbrdf-XXXXXX").string();
        if (!mkdtemp(pattern.data())) throw std::runtime_error("no temporary folder");
        path_ = pattern;
    }
    ~TemporaryDir()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryDir(const TemporaryDir&) = delete;
    TemporaryDir& operator=(const TemporaryDir&) = delete;

    /// Path of a file in it, whether it exists or not.
    std::string file(const std::string& name) const { return (path_ / name).string(); }

    /// Names of everything in it, sorted.
    std::vector<std::string> names() const
    {
        std::vector<std::string> all;
        for (const auto& entry : std::filesystem::directory_iterator(path_))
            all.push_back(entry.path().filename().string());
        std::sort(all.begin(), all.end());
        return all;
    }

private:
    std::filesystem::path path_;
};

}  // namespace fbrdf::test
