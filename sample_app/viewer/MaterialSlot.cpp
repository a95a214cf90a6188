#include "MaterialSlot.h"

#include <fbrdf/environment/LobeFit.h>
#include <fbrdf/io/MaterialFile.h>
#include <fbrdf/sources/OpenSource.h>

#include <fmt/core.h>
#include <unistd.h>

#include <utility>

namespace fbrdf::viewer {

MaterialSlot::MaterialSlot(const std::string& spec, FitOptions options)
    : name_(spec), options_(std::move(options))
{
    material_ = readIfMaterial(spec);
    if (!material_) source_ = openSource(spec);
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
    if (truthIsSource()) return source_->evaluate;
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
