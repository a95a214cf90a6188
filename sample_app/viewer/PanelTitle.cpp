#include "Panel.h"

#include <fmt/core.h>
#include <GLFW/glfw3.h>

namespace fbrdf::viewer {
namespace {

std::string messageOf(const PanelFacts& facts)
{
    if (!facts.fit.doing.empty()) return facts.fit.doing + " (C: cancel)";
    if (!facts.fit.problem.empty()) return facts.fit.problem;
    return facts.message.empty() ? "H: help" : facts.message;
}

std::string titleOf(const scene::ViewState& state, const PanelFacts& facts)
{
    if (state.help) {
        std::string text = "fbrdf:";
        for (const scene::KeyHelp& line : scene::keyHelp())
            text += fmt::format("  {} = {}", line.key, line.meaning);
        return text;
    }
    if (state.compare.on && facts.compare) {
        const auto& seats = facts.compare->seats;
        return fmt::format("fbrdf: {} | A: {} | B: {} | {} | {}",
                           compareModeName(state.compare.mode), seats[0].title, seats[1].title,
                           facts.compare->numbers, messageOf(facts));
    }
    const scene::SceneMaterial* const material = shownMaterial(state.document);
    return fmt::format("fbrdf: {} | {} | {} lights | {} passes | {:.1f} ms | {}",
                       shortName(material ? material->source : ""),
                       viewTechniqueName(state.document.technique), facts.lights, facts.passes,
                       facts.milliseconds, messageOf(facts));
}

}  // namespace

Panel::Panel(GLFWwindow* window) : window_(window) {}
Panel::~Panel() = default;

bool Panel::wantsMouse() const
{
    return false;
}

bool Panel::wantsKeys() const
{
    return false;
}

bool Panel::isHeld() const
{
    return false;
}

void Panel::draw(scene::ViewState& state, const PanelFacts& facts)
{
    setTitle(titleOf(state, facts), facts);
}

}  // namespace fbrdf::viewer
