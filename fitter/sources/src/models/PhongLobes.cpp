#include "PhongLobes.h"

#include <cmath>

namespace fbrdf {

double phongNormalisation(double n)
{
    return (n + 2.0) / (2.0 * kPi);
}

// At normal incidence theta_i = 2 theta_h. With c = cos theta_h, cos theta_i = 2 c^2 - 1 and
// d omega_i = 4 c d omega_h, so the albedo of (n.h)^n is
//   8 pi integral of (2 c^2 - 1) c^(n+1) dc from 1/sqrt(2) to 1
//     = 8 pi (n + 2^(-n/2)) / ((n + 2) (n + 4)).
double blinnPhongNormalisation(double n)
{
    return (n + 2.0) * (n + 4.0) / (8.0 * kPi * (n + std::exp2(-0.5 * n)));
}

bool diffuseAndSpecularSumToOne(const ModelValues& values)
{
    const Vec3d sum = colourOf(values, "kd") + colourOf(values, "ks");
    return sum.x <= 1.0 && sum.y <= 1.0 && sum.z <= 1.0;
}

std::vector<ModelParameter> phongParameters()
{
    return {albedoParameter("kd", 0.3, "albedo of the Lambertian part"),
            albedoParameter("ks", 0.3, "albedo of the lobe at normal incidence"),
            scalarParameter("n", 50.0, 0.0, 1e6, "exponent of the lobe")};
}

}  // namespace fbrdf
