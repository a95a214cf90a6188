#include "Tristimulus.h"

#include <fbrdf/sources/Spectrum.h>

#include <cmath>

namespace fbrdf {
namespace {

const Vec3d kDaylight(0.95047, 1.0, 1.08883);

/// Responses of the cones after Bradford.
Vec3d conesOf(const Vec3d& c)
{
    return {0.8951 * c.x + 0.2664 * c.y - 0.1614 * c.z, -0.7502 * c.x + 1.7135 * c.y + 0.0367 * c.z,
            0.0389 * c.x - 0.0685 * c.y + 1.0296 * c.z};
}

Vec3d xyzOfCones(const Vec3d& c)
{
    return {0.9869929 * c.x - 0.1470543 * c.y + 0.1599627 * c.z,
            0.4323053 * c.x + 0.5183603 * c.y + 0.0492912 * c.z,
            -0.0085287 * c.x + 0.0400428 * c.y + 0.9684867 * c.z};
}

Vec3d adapted(const Vec3d& xyz, const Vec3d& white)
{
    return linearSrgbFromXyz(xyzOfCones(conesOf(xyz) * conesOf(kDaylight) / conesOf(white)));
}

}  // namespace

Vec3d linearSrgbFromXyz(const Vec3d& xyz, XyzWhite white)
{
    return white == XyzWhite::d65 ? linearSrgbFromXyz(xyz) : adapted(xyz, Vec3d(1.0));
}

Vec3d linearSrgbFromXyz(const Vec3d& xyz, double whiteX, double whiteY)
{
    return adapted(xyz, Vec3d(whiteX / whiteY, 1.0, (1.0 - whiteX - whiteY) / whiteY));
}

std::string describeWhite(XyzWhite white)
{
    return white == XyzWhite::d65 ? "white of X, Y, Z is D65"
                                  : "white of X, Y, Z is equal energy (X = Y = Z)";
}

XyzWhite whiteOfXyz(const std::string& chosen, const Vec3d& sums,
                    std::vector<std::string>& assumptions)
{
    if (!chosen.empty()) return chosen == "d65" ? XyzWhite::d65 : XyzWhite::equalEnergy;
    const XyzWhite white = isGreyUnderD65(sums) ? XyzWhite::d65 : XyzWhite::equalEnergy;
    assumptions.push_back(describeWhite(white) + ", " +
                          (white == XyzWhite::d65
                               ? "as the sums of the table are; FILE@e takes equal energy"
                               : "as Radiance has it; FILE@d65 takes D65"));
    return white;
}

bool isGreyUnderD65(const Vec3d& sums)
{
    constexpr double kNear = 0.02;
    return sums.y > 0.0 && std::abs(sums.x / sums.y / kDaylight.x - 1.0) < kNear &&
           std::abs(sums.z / sums.y / kDaylight.z - 1.0) < kNear;
}

}  // namespace fbrdf
