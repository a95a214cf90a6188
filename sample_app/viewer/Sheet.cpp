#include "Sheet.h"

#include "LabelFont.h"
#include "SceneDrawing.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace fbrdf::viewer {
namespace {

constexpr int kGap = 8;                       ///< pixels between pictures
constexpr int kPixelsPerScale = 320;          ///< of a picture's width, for labels to grow with it
constexpr int kLargestSheet = 16384;          ///< pixels on a side
constexpr float kPaper = 0.02f, kInk = 0.8f;  ///< shares of what is shown white

/// Where the pictures are.
struct SheetLayout {
    int columns = 1, rows = 1;
    int width = 0, height = 0, label = 0;  ///< of a picture and of the strip below it, pixels

    int sheetWidth() const { return kGap + columns * (width + kGap); }
    int sheetHeight() const { return kGap + rows * (height + label + kGap); }
    int left(int column) const { return kGap + column * (width + kGap); }
    int top(int row) const { return kGap + row * (height + label + kGap); }
};

SheetLayout layoutOf(const Options& options, int materials, int lights, int label)
{
    SheetLayout layout{lights, materials, options.width, options.height, label};
    if (lights == 1) {
        layout.columns = static_cast<int>(std::ceil(std::sqrt(materials)));
        layout.rows = (materials + layout.columns - 1) / layout.columns;
    }
    if (layout.sheetWidth() > kLargestSheet || layout.sheetHeight() > kLargestSheet)
        throw Error(
            ErrorKind::usage, "sheet",
            Found(std::to_string(layout.sheetWidth()) + "x" + std::to_string(layout.sheetHeight()) +
                  " pixels")
                .expected("up to " + std::to_string(kLargestSheet) + " a side; see --size"));
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
std::string labelOf(const std::string& name)
{
    const std::filesystem::path path(name);
    return std::filesystem::exists(path) ? path.stem().string() : name;
}

void paste(const scene::Image& picture, int left, int top, scene::Image& sheet)
{
    for (int y = 0; y < picture.height; ++y)
        std::copy_n(picture.pixel(0, y), 4 * picture.width, sheet.pixel(left, top + y));
}

scene::Image paper(const SheetLayout& layout, float radiance)
{
    scene::Image sheet(layout.sheetWidth(), layout.sheetHeight());
    for (size_t i = 0; i < sheet.rgba.size(); ++i) sheet.rgba[i] = i % 4 == 3 ? 1.0f : radiance;
    return sheet;
}

/// The name of the material to the left, and what lights it, where that differs, to the right.
void drawLabels(const LabelFont& font, const LabelPlace& strip, const std::string& material,
                const std::string& light, float ink, scene::Image& sheet)
{
    const int right = light.empty() ? 0 : std::min(font.widthOf(light) + kGap, strip.width / 2);
    font.draw(sheet, {strip.x, strip.y, strip.width - right}, material, ink);
    if (!light.empty())
        font.draw(sheet, {strip.x + strip.width - right + kGap, strip.y, right - kGap}, light,
                  0.5f * ink);
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
    scene::Image sheet = paper(layout, kPaper / options.document.exposure);
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
                       labelOf(world.materials[static_cast<size_t>(material)].name()),
                       lights.size() == 1 ? "" : labelOf(lights[i]),
                       kInk / options.document.exposure, sheet);
        }
    }
    return sheet;
}

}  // namespace fbrdf::viewer
