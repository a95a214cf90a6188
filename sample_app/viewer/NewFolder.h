// NewFolder.h - a folder for the files of a command that writes several.
#pragma once
#include <string>

namespace fbrdf::viewer {

/// A folder that goes again unless it is kept, where it was not there before. Throws Error(output)
/// where it cannot be made.
class NewFolder {
public:
    explicit NewFolder(const std::string& path);
    ~NewFolder();
    NewFolder(const NewFolder&) = delete;
    NewFolder& operator=(const NewFolder&) = delete;

    void keep() { isNew_ = false; }

private:
    std::string path_;
    bool isNew_ = false;
};

}  // namespace fbrdf::viewer
