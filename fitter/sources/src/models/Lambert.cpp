// A perfectly diffuse reflector.
#include "ModelBuild.h"

namespace fbrdf {
namespace {

BrdfFunction make(const ModelValues& values)
{
    const Vec3d f = colourOf(values, "albedo") / kPi;
    return [f](const Vec3d&, const Vec3d&) { return f; };
}

}  // namespace

Model lambertModel()
{
    return {"lambert",
            "Lambertian",
            "Lambert 1760, Photometria",
            {albedoParameter("albedo", 0.5, "share of the light that is reflected")},
            always,
            {"always", always},
            make};
}

}  // namespace fbrdf
