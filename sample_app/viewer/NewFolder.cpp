#include "NewFolder.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <filesystem>

namespace fbrdf::viewer {

NewFolder::NewFolder(const std::string& path) : path_(path)
{
    std::error_code error;
    isNew_ = std::filesystem::create_directory(path, error);
    if (error || !std::filesystem::is_directory(path))
        throw Error(ErrorKind::output, path,
                    Found(error ? systemErrorText(error.value()) : "no folder")
                        .expected("a folder to fill"));
}

NewFolder::~NewFolder()
{
    std::error_code ignored;
    if (isNew_) std::filesystem::remove(path_, ignored);
}

}  // namespace fbrdf::viewer
