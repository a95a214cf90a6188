// The integral is taken over half vectors, dw_o = 4 (wi.h) dw_h: every wo above the horizon is the
// mirror image of wi about exactly one h, and highlights sit at the pole, where theta_h = pi/2 u^2
// puts most points. Tables have kinks at their nodes, and the integrand has one at the horizon, so
// a fixed rule of a higher order gains nothing: both integrals refine where the integrand asks.
#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/metrics/Metrics.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace fbrdf {
namespace {

/// Two estimates that differ by less agree. What is left is below 1e-4 (PhysicsErrorsTest.cpp).
constexpr double kAgreement = 2e-5;
/// Azimuths of a ring, doubled until two sums agree. 16 hit the highlights of anisotropic
/// materials, which lie along the axes.
constexpr int kFewestAzimuths = 16, kMostAzimuths = 128;
/// Parts of u, each halved up to three times. Fewer parts miss narrow kinks altogether.
constexpr int kParts = 32, kHalvings = 3;

double largest(const Vec3d& v)
{
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// The azimuths of rings: first those of the coarsest ring, then at each doubling those that lie
/// half way between the ones before.
const std::vector<Vec3d>& azimuths()
{
    static const std::vector<Vec3d> all = [] {
        std::vector<Vec3d> made;
        for (int j = 0; j < kFewestAzimuths; ++j)
            made.push_back(directionFromAngles(0.5 * kPi, 2.0 * kPi * j / kFewestAzimuths));
        for (int count = kFewestAzimuths; count < kMostAzimuths; count *= 2)
            for (int j = 0; j < count; ++j)
                made.push_back(directionFromAngles(0.5 * kPi, 2.0 * kPi * (j + 0.5) / count));
        return made;
    }();
    return all;
}

/// The integral over u in [0, 1] of integrals over rings of half vectors.
class AlbedoIntegral {
public:
    AlbedoIntegral(const BrdfFunction& brdf, const Vec3d& wi) : brdf_(brdf), wi_(wi) {}

    Vec3d value() const
    {
        Vec3d sum(0.0), from = ring(0.0);
        for (int part = 0; part < kParts; ++part) {
            const double a = double(part) / kParts, b = double(part + 1) / kParts;
            const Vec3d middle = ring(0.5 * (a + b)), to = ring(b);
            sum += simpson({a, b, from, middle, to}, 2.0 * kAgreement / kParts, kHalvings);
            from = to;
        }
        return sum;
    }

private:
    /// Part of u with the integrand at its ends and its middle.
    struct Part {
        double a, b;
        Vec3d from, middle, to;
    };

    Vec3d at(const Vec3d& h) const
    {
        const double cosTheta_d = glm::dot(wi_, h);
        const Vec3d wo = 2.0 * cosTheta_d * h - wi_;
        if (!(cosTheta_d > 0.0) || !(wo.z > 0.0)) return Vec3d(0.0);
        return brdf_(wo, wi_) * (4.0 * cosTheta_d * wo.z);
    }

    /// Integrand over u: the trapezoidal rule over the azimuth, which is periodic.
    Vec3d ring(double u) const
    {
        const double theta_h = 0.5 * kPi * u * u, sine = std::sin(theta_h),
                     cosine = std::cos(theta_h);
        const double width = kPi * u * sine * 2.0 * kPi;
        Vec3d sum(0.0), before(0.0);
        int done = 0;
        for (int count = kFewestAzimuths; count <= kMostAzimuths; count *= 2) {
            for (; done < count; ++done) {
                const Vec3d& equator = azimuths()[static_cast<size_t>(done)];
                sum += at({sine * equator.x, sine * equator.y, cosine});
            }
            const Vec3d now = sum * (width / count);
            const bool agrees = largest(now - before) <= 4.0 * kAgreement;
            before = now;
            if (agrees && count > kFewestAzimuths) break;
        }
        return before;
    }

    /// Simpson's rule; the two halves of the part alone tell how good it is.
    Vec3d simpson(const Part& part, double agreement, int halvings) const
    {
        const double width = part.b - part.a, middle = 0.5 * (part.a + part.b);
        const Vec3d left = ring(0.5 * (part.a + middle)), right = ring(0.5 * (middle + part.b));
        const Vec3d whole = width / 6.0 * (part.from + 4.0 * part.middle + part.to);
        const Vec3d halves =
            width / 12.0 * (part.from + 4.0 * left + 2.0 * part.middle + 4.0 * right + part.to);
        const Vec3d error = (halves - whole) / 15.0;
        if (halvings == 0 || largest(error) <= agreement) return halves + error;
        return simpson({part.a, middle, part.from, left, part.middle}, 0.5 * agreement,
                       halvings - 1) +
               simpson({middle, part.b, part.middle, right, part.to}, 0.5 * agreement,
                       halvings - 1);
    }

    const BrdfFunction& brdf_;
    Vec3d wi_;
};

}  // namespace

Vec3d directionalAlbedo(const BrdfFunction& brdf, double theta_i, double phi_i)
{
    return AlbedoIntegral(brdf, directionFromAngles(theta_i, phi_i)).value();
}

}  // namespace fbrdf
