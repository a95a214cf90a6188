#include "Sheet.h"

#include "LabelFont.h"
#include "SceneDrawing.h"
#include "SheetLayout.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace fbrdf::viewer {
namespace {

SheetLayout layoutOf(const Options& options, int materials, int lights, int label)
{
    SheetLayout layout{lights, materials, options.width, options.height, label};
    if (lights == 1) {
        layout.columns = static_cast<int>(std::ceil(std::sqrt(materials)));
        layout.rows = (materials + layout.columns - 1) / layout.columns;
    }
    checkLayout(layout);
    return layout;
}

/// Lights the world by an environment or by a file of lights; "" leaves it as it is.
void lightBy(const std::string& under, const Options& options, World& world)
{
    if (under.empty()) return;
    const bool isFile = std::filesystem::path(under).extension() == ".json";
    scene::SceneEnvironment environment = options.document.environment;
    environment.name = isFile ? "" : under;
    world.environment = environmentFrom(environment);
    if (isFile) world.lights = scene::readLights(under);
}

/// A file without folders and ending; a model as it is.
std::string stemOf(const std::string& name)
{
    const std::filesystem::path path(name);
    return std::filesystem::exists(path) ? path.stem().string() : name;
}

/// The name of the material to the left, and what lights it, where that differs, to the right.
void drawLabels(const LabelFont& font, const LabelPlace& strip, const std::string& material,
                const std::string& light, float ink, scene::Image& sheet)
{
    const int right =
        light.empty() ? 0 : std::min(font.widthOf(light) + kSheetGap, strip.width / 2);
    font.draw(sheet, {strip.x, strip.y, strip.width - right}, material, ink);
    if (!light.empty())
        font.draw(sheet, {strip.x + strip.width - right + kSheetGap, strip.y, right - kSheetGap},
                  light, 0.5f * ink);
}

}  // namespace

scene::Image drawSheet(const Options& options, World& world)
{
    const std::vector<std::string> lights =
        options.under.empty() ? std::vector<std::string>{""} : options.under;
    const auto materials = static_cast<int>(world.materials.size());
    const LabelFont font(std::max(1, options.width / kPixelsPerScale));
    const SheetLayout layout = layoutOf(options, materials, static_cast<int>(lights.size()),
                                        font.height() + font.height() / 2);
    scene::Image sheet = paperOf(layout, kSheetPaper / options.document.exposure);
    const scene::LightSet ownLights = world.lights;
    std::optional<SceneDrawing> drawing;
    for (size_t i = 0; i < lights.size(); ++i) {
        world.lights = ownLights;
        lightBy(lights[i], options, world);
        if (drawing)
            drawing->followLights();
        else
            drawing.emplace(options, world);
        for (int material = 0; material < materials; ++material) {
            const int place =
                lights.size() == 1 ? material : material * layout.columns + static_cast<int>(i);
            const int left = layout.left(place % layout.columns),
                      top = layout.top(place / layout.columns);
            paste(drawing->draw({&world.mesh, glm::mat4(1.0f), material}), left, top, sheet);
            drawLabels(font, {left, top + layout.height + font.height() / 4, layout.width},
                       stemOf(world.materials[static_cast<size_t>(material)].name()),
                       lights.size() == 1 ? "" : stemOf(lights[i]),
                       kSheetInk / options.document.exposure, sheet);
        }
    }
    return sheet;
}

}  // namespace fbrdf::viewer
