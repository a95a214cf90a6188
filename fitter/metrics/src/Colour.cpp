#include <fbrdf/metrics/Colour.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

constexpr double kReferenceWhite = 203.0;  // cd/m2, BT.2408

double dot3(double a, double b, double c, const Vec3d& v)
{
    return a * v.x + b * v.y + c * v.z;
}

}  // namespace

double pqFromLuminance(double luminance)
{
    // BT.2100 Table 4.
    constexpr double m1 = 2610.0 / 16384.0, m2 = 2523.0 / 4096.0 * 128.0;
    constexpr double c1 = 3424.0 / 4096.0, c2 = 2413.0 / 4096.0 * 32.0, c3 = 2392.0 / 4096.0 * 32.0;
    const double y = std::pow(std::clamp(luminance / 10000.0, 0.0, 1.0), m1);
    return std::pow((c1 + c2 * y) / (1.0 + c3 * y), m2);
}

Vec3d itpFromLinear(const Vec3d& rgb)
{
    // BT.2087-0, Rec. 709 to Rec. 2020.
    const Vec3d wide = kReferenceWhite * Vec3d(dot3(0.6274, 0.3293, 0.0433, rgb),
                                               dot3(0.0691, 0.9195, 0.0114, rgb),
                                               dot3(0.0164, 0.0880, 0.8956, rgb));
    // BT.2100 Table 7: LMS, then IC_TC_P of the PQ-coded cone responses, in 4096ths.
    const Vec3d lms(pqFromLuminance(dot3(1688, 2146, 262, wide) / 4096.0),
                    pqFromLuminance(dot3(683, 2951, 462, wide) / 4096.0),
                    pqFromLuminance(dot3(99, 309, 3688, wide) / 4096.0));
    const double ct = dot3(6610, -13613, 7003, lms) / 4096.0;
    const double cp = dot3(17933, -17390, -543, lms) / 4096.0;
    return {0.5 * (lms.x + lms.y), 0.5 * ct, cp};
}

double deltaEItp(const Vec3d& itpA, const Vec3d& itpB)
{
    return 720.0 * glm::length(itpA - itpB);
}

}  // namespace fbrdf
