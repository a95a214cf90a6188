#include "FreeName.h"

#include <fmt/core.h>

#include <filesystem>

namespace fbrdf::viewer {

std::string freeName(const std::string& stem, const std::string& ending)
{
    for (int number = 1;; ++number) {
        std::string name = fmt::format("{}-{:03}{}", stem, number, ending);
        if (!std::filesystem::exists(std::filesystem::symlink_status(name))) return name;
    }
}

}  // namespace fbrdf::viewer
