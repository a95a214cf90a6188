#include "MaterialSlot.h"

#include <fbrdf/environment/LobeFit.h>
#include <fbrdf/io/MaterialFile.h>
#include <fbrdf/sources/OpenSource.h>

#include <fmt/core.h>
#include <unistd.h>

#include <utility>

namespace fbrdf::viewer {

FitOptions fitOptionsOf(const scene::SceneMaterial& material)
{
    FitOptions options;
    options.form = material.form;
    options.resolution = material.resolution;
    options.smoothness = material.smoothness;
    options.maxBytes = 1024 * static_cast<size_t>(material.kilobytes);
    return options;
}

MaterialSlot::MaterialSlot(const std::string& spec, FitOptions options)
    : name_(spec), options_(std::move(options))
{
    material_ = readIfMaterial(spec);
    if (!material_) source_ = std::make_shared<const Source>(openSource(spec));
}

MaterialSlot::MaterialSlot(const std::string& spec, std::shared_ptr<const Source> source,
                           FitOptions options)
    : name_(spec), options_(std::move(options)), source_(std::move(source))
{
}

MaterialSlot::MaterialSlot(const std::string& spec, std::shared_ptr<const Source> source,
                           Material material)
{
    replace(spec, std::move(source), std::move(material));
}

void MaterialSlot::replace(const std::string& spec, std::shared_ptr<const Source> source,
                           Material material)
{
    name_ = spec;
    source_ = std::move(source);
    material_ = std::move(material);
    lobes_.reset();
}

const Material& MaterialSlot::material()
{
    if (!material_) {
        if (isatty(STDERR_FILENO)) fmt::print(stderr, "fitting {} ...\n", name_);
        material_ = fitMaterial(*source_, options_).material;
    }
    return *material_;
}

scene::Brdf MaterialSlot::truth()
{
    // The function keeps its source.
    if (truthIsSource())
        return [source = source_](const Vec3d& wo, const Vec3d& wi) {
            return source->evaluate(wo, wi);
        };
    return [&drawn = material()](const Vec3d& wo, const Vec3d& wi) {
        return evaluate<double>(drawn, wo, wi);
    };
}

const LobeTable& MaterialSlot::lobes()
{
    if (lobes_) return *lobes_;
    if (truthIsSource())
        lobes_ = fitLobes(source_->evaluate, source_->isotropic);
    else
        lobes_ = material().lobes.isEmpty() ? fitLobes(material()) : material().lobes;
    return *lobes_;
}

}  // namespace fbrdf::viewer
