// What both panels have in common.
#include "Panel.h"

#include <GLFW/glfw3.h>

#include <filesystem>
#include <utility>

namespace fbrdf::viewer {

std::string shortName(const std::string& spec)
{
    if (spec.empty()) return "none";
    const std::filesystem::path path(spec);
    return std::filesystem::exists(path) ? path.filename().string() : spec;
}

void Panel::setTitle(std::string title, const PanelFacts& facts)
{
    if (facts.isDrawing) title += " ...";
    if (title == title_) return;
    title_ = std::move(title);
    glfwSetWindowTitle(window_, title_.c_str());
}

}  // namespace fbrdf::viewer
