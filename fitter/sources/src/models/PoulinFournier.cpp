// Parallel cylinders, raised from a plane or cut into it, with exact shadowing and masking and no
// multiple scattering: the model on which the papers of docs/method.md measure their errors.
//
// Every point of the section reflects like a normalised Blinn-Phong surface (Lambertian part kd,
// lobe ks (n.h)^n). The BRDF of the surface, per unit of its area, is the mean over a period
//   f = 1 / (period wi.z wo.z) integral of f_local (n.wi)(n.wo) dl
// over the points that both see the light and are seen: Poulin and Fournier 1990, section 3. Both
// sets are intervals in closed form (CylinderProfile.h). The diffuse integral is exact; the lobe is
// integrated by Gauss-Legendre over the part of the interval where it is not negligible, in place
// of the paper's Chebyshev approximation.
#include "CylinderProfile.h"
#include "Microfacet.h"
#include "PhongLobes.h"

#include <algorithm>

namespace fbrdf {
namespace {

// A profile flatter than this is a plane to double precision.
constexpr double kFlat = 1e-6;

/// Angle from the vertical of a vector's part in the section.
double sectionAngle(const Vec3d& w)
{
    return std::atan2(w.y, w.z);
}

struct Node {
    double x, weight;
};
/// Positive half of the 16-point Gauss-Legendre rule on [-1, 1].
constexpr Node kGauss16[8] = {
    {0.095012509837637454, 0.18945061045506859}, {0.28160355077925892, 0.18260341504492361},
    {0.45801677765722737, 0.16915651939500262},  {0.61787624440264377, 0.14959598881657676},
    {0.755404408355003, 0.12462897125553403},    {0.86563120238783176, 0.095158511682492591},
    {0.9445750230732326, 0.062253523938647706},  {0.98940093499164994, 0.027152459411754037}};

/// Integral over angles of f(sine, cosine). The two points of a node share their sine and cosine.
template <class F>
double integrate(const Interval& angles, const F& f)
{
    if (!(angles.length() > 0.0)) return 0.0;
    const double middle = 0.5 * (angles.lower + angles.upper), half = 0.5 * angles.length();
    const double sine = std::sin(middle), cosine = std::cos(middle);
    double sum = 0.0;
    for (const Node& node : kGauss16) {
        const double s = std::sin(half * node.x), c = std::cos(half * node.x);
        sum += node.weight * (f(sine * c - cosine * s, cosine * c + sine * s) +
                              f(sine * c + cosine * s, cosine * c - sine * s));
    }
    return half * sum;
}

/// The integrals over a lit and visible piece of an arc, given by the angles of its normals from
/// the vertical: psi on a cylinder, -psi in a groove.
struct ArcIntegrals {
    Vec3d wi, wo, h;
    double exponent;

    /// Integral of (n.wi)(n.wo), exact: with w = r (sin gamma, cos gamma) in the section,
    /// cos(psi - gamma_i) cos(psi - gamma_o) is half of cos(gamma_i - gamma_o) plus
    /// cos(2 psi - gamma_i - gamma_o).
    double diffuse(const Interval& normals) const
    {
        const double length = normals.length(), middle = normals.lower + normals.upper;
        const double constant = wi.y * wo.y + wi.z * wo.z;
        const double cosine = wi.z * wo.z - wi.y * wo.y, sine = wi.z * wo.y + wi.y * wo.z;
        return 0.5 * (length * constant +
                      std::sin(length) * (std::cos(middle) * cosine + std::sin(middle) * sine));
    }

    /// Integral of (n.h)^n (n.wi)(n.wo).
    double lobe(const Interval& normals) const
    {
        // cos(x)^n < e^(-n x^2 / 2): beyond sqrt(nearest^2 + 56 / n) the lobe is below e^-28 of
        // its value at the point nearest to the peak.
        const double peak = sectionAngle(h);
        const double split = std::clamp(peak, normals.lower, normals.upper);
        const double reach =
            std::sqrt((split - peak) * (split - peak) + 56.0 / std::max(exponent, 1.0));
        const Interval window = intersection(normals, {peak - reach, peak + reach});
        const auto f = [this](double s, double c) {
            const double cosine = std::max(0.0, s * h.y + c * h.z);
            return std::pow(cosine, exponent) * (s * wi.y + c * wi.z) * (s * wo.y + c * wo.z);
        };
        return integrate({window.lower, split}, f) + integrate({split, window.upper}, f);
    }
};

/// Integrals of the two local terms over one period.
struct PeriodIntegrals {
    double diffuse = 0.0, lobe = 0.0;
};

PeriodIntegrals integratePeriod(const CylinderProfile& profile, double exponent, const Vec3d& wo,
                                const Vec3d& wi)
{
    const Vec3d h = HalfGeometry(wo, wi).h;
    const double gamma_i = sectionAngle(wi), gamma_o = sectionAngle(wo);
    PeriodIntegrals result;
    const Interval points = intersection(profile.visibleArc(gamma_i), profile.visibleArc(gamma_o));
    if (points.length() > 0.0) {
        const ArcIntegrals arc{wi, wo, h, exponent};
        const Interval normals = profile.isGroove() ? points.mirrored() : points;
        // Rounding leaves (n.w) just below 0 at the ends of an interval.
        result = {std::max(0.0, arc.diffuse(normals)), std::max(0.0, arc.lobe(normals))};
    }
    const double floor =
        intersection(profile.visibleFloor(gamma_i), profile.visibleFloor(gamma_o)).length() * wi.z *
        wo.z;
    result.diffuse += floor;
    result.lobe += floor * std::pow(h.z, exponent);
    return result;
}

BrdfFunction makeFlat(const Vec3d& diffuse, const Vec3d& specular, double n)
{
    return [=](const Vec3d& wo, const Vec3d& wi) {
        return diffuse + specular * std::pow(HalfGeometry(wo, wi).h.z, n);
    };
}

bool isFlat(const ModelValues& values)
{
    return std::abs(scalarOf(values, "height")) < kFlat;
}

BrdfFunction make(const ModelValues& values)
{
    const double n = scalarOf(values, "n");
    const Vec3d diffuse = colourOf(values, "kd") / kPi;
    const Vec3d specular = colourOf(values, "ks") * blinnPhongNormalisation(n);
    if (isFlat(values)) return makeFlat(diffuse, specular, n);
    const CylinderProfile profile(scalarOf(values, "height"), scalarOf(values, "spacing"));
    return [=](const Vec3d& wo, const Vec3d& wi) {
        const PeriodIntegrals integrals = integratePeriod(profile, n, wo, wi);
        const double area = profile.period() * wi.z * wo.z;
        return diffuse * (integrals.diffuse / area) + specular * (integrals.lobe / area);
    };
}

}  // namespace

Model poulinFournierModel()
{
    std::vector<ModelParameter> parameters = phongParameters();
    parameters.push_back(
        scalarParameter("height", 0.5, -1.0, 1.0,
                        "crest above the plane in cylinder radii; < 0: depth of grooves"));
    parameters.push_back(scalarParameter(
        "spacing", 1.25, 1.0, 100.0, "distance of the axes in widths of an arc; 1: they touch"));
    return {
        "poulin-fournier",
        "Poulin-Fournier, parallel cylinders or grooves",
        "Poulin and Fournier 1990, A Model for Anisotropic Reflection; one direction of "
        "cylinders along the tangent, opaque, Blinn-Phong at each point, no multiple scattering",
        parameters,
        isFlat,
        {"kd + ks <= 1", diffuseAndSpecularSumToOne},
        make};
}

}  // namespace fbrdf
