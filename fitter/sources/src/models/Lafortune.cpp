// One generalised cosine lobe over a Lambertian.
#include "ModelBuild.h"

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

// |C . (wi wo)| is at most the largest coefficient, so 2^1000 bounds the lobe: a finite double.
constexpr double kCoefficientMax = 2.0, kExponentMax = 1000.0;

BrdfFunction make(const ModelValues& values)
{
    const Vec3d diffuse = colourOf(values, "kd") / kPi;
    const Vec3d cx = colourOf(values, "cx"), cy = colourOf(values, "cy"),
                cz = colourOf(values, "cz");
    const Vec3d n = colourOf(values, "n");
    return [=](const Vec3d& wo, const Vec3d& wi) {
        // Lafortune et al. 1997, section 4: (Cx ux vx + Cy uy vy + Cz uz vz)^n, 0 where negative.
        const Vec3d dot = cx * (wi.x * wo.x) + cy * (wi.y * wo.y) + cz * (wi.z * wo.z);
        Vec3d f = diffuse;
        for (int c = 0; c < 3; ++c)
            if (dot[c] > 0.0) f[c] += std::pow(dot[c], n[c]);
        return f;
    };
}

bool isotropic(const ModelValues& values)
{
    return colourOf(values, "cx") == colourOf(values, "cy");
}

ModelParameter coefficient(const char* name, double initial, const char* meaning)
{
    return colourParameter(name, initial, -kCoefficientMax, kCoefficientMax, meaning);
}

}  // namespace

Model lafortuneModel()
{
    return {"lafortune",
            "Lafortune, one generalised cosine lobe",
            "Lafortune et al. 1997, Non-Linear Approximation of Reflectance Functions; the "
            "coefficients hold the lobe's scale, as in the paper",
            {albedoParameter("kd", 0.2, "albedo of the Lambertian part"),
             coefficient("cx", -1.0, "weight of x x': -1 mirrors, 1 is retro-reflection"),
             coefficient("cy", -1.0, "weight of y y'"), coefficient("cz", 1.0, "weight of z z'"),
             colourParameter("n", 20.0, 0.0, kExponentMax, "exponent of the lobe")},
            isotropic,
            {"", never},
            make};
}

}  // namespace fbrdf
