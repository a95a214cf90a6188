#include "Figures.h"

#include "ComparePicture.h"
#include "CpuDrawing.h"
#include "Headless.h"
#include "HeatScale.h"
#include "NewFolder.h"

#include <fbrdf/base/OutputFile.h>
#include <nlohmann/json.hpp>

namespace fbrdf::viewer {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSamples = 4;  // a pixel, of every picture
constexpr const char* kSatin = "poulin-fournier:kd=0.08/0.12/0.4,ks=0.35";
constexpr const char* kMaterials[] = {
    kSatin,
    "ggx:alpha_x=0.12,alpha_y=0.4,f0=1.0/0.77/0.34",
    "ggx:alpha=0.12,f0=0.04,kd=0.55/0.05/0.04",
    "ward-brushed-aluminium",
    "ward-white-ceramic-tile",
    "disney:baseColor=0.03/0.2/0.08,roughness=0.9,sheen=1,sheenTint=1"};

/// form: of the fits; empty: the one that is asked for.
Options sceneOf(const Options& options, const std::vector<std::string>& materials, int lights,
                std::string form = "")
{
    Options scene = options;
    scene.command = Command::view;
    // auto would search for a minute.
    if (form.empty()) form = scene.figureForm == "auto" ? "io+pqpr" : scene.figureForm;
    for (const std::string& source : materials) scene.document.materials.push_back({source, form});
    scene.document.mesh = "knot";
    scene.document.lights.made = lights;
    scene.document.samples = kSamples;
    return scene;
}

scene::Image drawn(Options options, World& world, scene::ViewTechnique technique)
{
    options.document.technique = technique;
    return (isOnCpu(technique) ? drawOnCpu(options, world) : drawHeadless(options, world)).image;
}

/// Collects files and numbers.
class FigureFiles {
public:
    explicit FigureFiles(const Options& options) : options_(options) {}

    void add(const std::string& name, const scene::Image& image)
    {
        addFile(name, image, options_.document.exposure);
    }
    /// A picture, its error map and its numbers.
    void add(const std::string& name, const scene::Image& image, const scene::Image& reference)
    {
        add(name, image);
        addFile(name + "-error", heatMap(image, reference, options_.document.exposure), 1.0f);
        const ImageErrors errors = imageErrors(shownImage(image, {options_.document.exposure}),
                                               shownImage(reference, {options_.document.exposure}));
        numbers_[name] = {{"psnr_linear", errors.psnrLinear},
                          {"psnr_srgb", errors.psnrSrgb},
                          {"ssim", errors.ssim},
                          {"delta_e_itp", errors.deltaEItp},
                          {"flip", errors.flip}};
    }
    void commit()
    {
        files_.add(options_.out + "/figures.json", numbers_.dump(2) + "\n");
        files_.commit();
    }

private:
    void addFile(const std::string& name, const scene::Image& image, float exposure)
    {
        const std::string path = options_.out + "/" + name + ".png";
        files_.add(path, encodeImage(image, path, exposure, Transfer::srgb));
    }

    const Options& options_;
    OutputFiles files_;
    Json numbers_;
};

void addFigure1(const Options& given, FigureFiles& files)
{
    const Options options = sceneOf(given, {kSatin}, 4, "pqp");
    World world;
    loadWorld(options, world);
    const scene::Image reference = drawn(options, world, scene::ViewTechnique::reference);
    files.add("figure-1-reference", reference);
    files.add("figure-1a", drawn(options, world, scene::ViewTechnique::vertex), reference);
    files.add("figure-1b", drawn(options, world, scene::viewTechnique(Technique::twoLookup)),
              reference);
}

void addFigure2(const Options& given, FigureFiles& files)
{
    const Options options = sceneOf(given, {std::begin(kMaterials), std::end(kMaterials)}, 8);
    World world;
    loadWorld(options, world);
    const scene::Image reference = drawn(options, world, scene::ViewTechnique::reference);
    files.add("figure-2-reference", reference);
    files.add("figure-2", drawn(options, world, scene::viewTechnique(Technique::batched)),
              reference);
}

}  // namespace

void writeFigures(const Options& options)
{
    NewFolder folder(options.out);
    FigureFiles files(options);
    addFigure1(options, files);
    addFigure2(options, files);
    files.commit();
    folder.keep();
}

}  // namespace fbrdf::viewer
