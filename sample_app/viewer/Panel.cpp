// What both panels have in common.
#include "Panel.h"

#include <GLFW/glfw3.h>

#include <filesystem>

namespace fbrdf::viewer {

std::string shortName(const std::string& spec)
{
    if (spec.empty()) return "none";
    const std::filesystem::path path(spec);
    return std::filesystem::exists(path) ? path.filename().string() : spec;
}

void Panel::setTitle(const std::string& title)
{
    if (title == title_) return;
    title_ = title;
    glfwSetWindowTitle(window_, title.c_str());
}

}  // namespace fbrdf::viewer
