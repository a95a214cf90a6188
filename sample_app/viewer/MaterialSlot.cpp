#include "MaterialSlot.h"

#include <fbrdf/fit/Fit.h>
#include <fbrdf/io/MaterialFile.h>

namespace fbrdf::viewer {

const char* const kDefaultMaterial = "ggx:alpha_x=0.12,alpha_y=0.38,f0=1.0/0.71/0.29,kd=0";

MaterialSlot::MaterialSlot(const std::string& spec) : name_(spec)
{
    if (isMaterialFile(spec))
        material_ = readMaterial(spec);
    else
        source_ = openSource(spec);
}

const Material& MaterialSlot::material()
{
    if (!material_) material_ = fitMaterial(*source_).material;
    return *material_;
}

scene::Brdf MaterialSlot::truth()
{
    if (truthIsSource()) return source_->evaluate;
    return [&drawn = material()](const Vec3d& wo, const Vec3d& wi) {
        return evaluate<double>(drawn, wo, wi);
    };
}

}  // namespace fbrdf::viewer
