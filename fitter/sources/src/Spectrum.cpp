#include <fbrdf/sources/Spectrum.h>

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Number.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fbrdf {
namespace {

constexpr int kFirst = 380, kLast = 780, kStep = 10;
constexpr size_t kCount = (kLast - kFirst) / kStep + 1;
using Curve = std::array<double, kCount>;

// CIE 1931 2 degree observer, CIE 15:2004 table T.4.
constexpr Curve kX = {0.001368, 0.004243, 0.014310, 0.043510, 0.134380, 0.283900, 0.348280,
                      0.336200, 0.290800, 0.195360, 0.095640, 0.032010, 0.004900, 0.009300,
                      0.063270, 0.165500, 0.290400, 0.433450, 0.594500, 0.762100, 0.916300,
                      1.026300, 1.062200, 1.002600, 0.854450, 0.642400, 0.447900, 0.283500,
                      0.164900, 0.087400, 0.046770, 0.022700, 0.011359, 0.005790, 0.002899,
                      0.001440, 0.000690, 0.000332, 0.000166, 0.000083, 0.000042};
constexpr Curve kY = {0.000039, 0.000120, 0.000396, 0.001210, 0.004000, 0.011600, 0.023000,
                      0.038000, 0.060000, 0.090980, 0.139020, 0.208020, 0.323000, 0.503000,
                      0.710000, 0.862000, 0.954000, 0.994950, 0.995000, 0.952000, 0.870000,
                      0.757000, 0.631000, 0.503000, 0.381000, 0.265000, 0.175000, 0.107000,
                      0.061000, 0.032000, 0.017000, 0.008210, 0.004102, 0.002091, 0.001047,
                      0.000520, 0.000249, 0.000120, 0.000060, 0.000030, 0.000015};
constexpr Curve kZ = {0.006450, 0.020050, 0.067850, 0.207400, 0.645600, 1.385600, 1.747060,
                      1.772110, 1.669200, 1.287640, 0.812950, 0.465180, 0.272000, 0.158200,
                      0.078250, 0.042160, 0.020300, 0.008750, 0.003900, 0.002100, 0.001650,
                      0.001100, 0.000800, 0.000340, 0.000190, 0.000050, 0.000020, 0.0,
                      0.0,      0.0,      0.0,      0.0,      0.0,      0.0,      0.0,
                      0.0,      0.0,      0.0,      0.0,      0.0,      0.0};
// Standard illuminant D65, CIE 15:2004 table T.1, relative.
constexpr Curve kD65 = {49.9755, 54.6482, 82.7549, 91.4860, 93.4318, 86.6823, 104.865,
                        117.008, 117.812, 114.861, 115.923, 108.811, 109.354, 107.802,
                        104.790, 107.689, 104.405, 104.046, 100.000, 96.3342, 95.7880,
                        88.6856, 90.0062, 89.5991, 87.6987, 83.2886, 83.6992, 80.0268,
                        80.2146, 82.2778, 78.2842, 69.7213, 71.6091, 74.3490, 61.6040,
                        69.8856, 75.0870, 63.5927, 46.4182, 66.8054, 63.3828};

double at(const Curve& curve, double wavelength)
{
    const double position = std::clamp((wavelength - kFirst) / kStep, 0.0, double(kCount - 1));
    const size_t lower = std::min(static_cast<size_t>(position), kCount - 2);
    const double blend = position - double(lower);
    return curve[lower] * (1.0 - blend) + curve[lower + 1] * blend;
}

/// What one nanometre of a white surface under D65 adds to linear sRGB, up to a factor.
Vec3d lineColour(double wavelength)
{
    return linearSrgbFromXyz({at(kX, wavelength), at(kY, wavelength), at(kZ, wavelength)}) *
           at(kD65, wavelength);
}

void requireAscending(const std::vector<double>& wavelengths)
{
    double last = 0.0;
    for (const double wavelength : wavelengths) {
        if (!(wavelength > last) || !std::isfinite(wavelength))
            throw Error(
                ErrorKind::input, "spectrum",
                Found("wavelength " + numberText(wavelength) + " nm after " + numberText(last))
                    .expected("ascending wavelengths above 0"));
        last = wavelength;
    }
    if (wavelengths.empty())
        throw Error(ErrorKind::input, "spectrum", Found("no wavelength").expected("at least one"));
}

}  // namespace

Vec3d linearSrgbFromXyz(const Vec3d& c)
{
    return {3.2404542 * c.x - 1.5371385 * c.y - 0.4985314 * c.z,
            -0.9692660 * c.x + 1.8760108 * c.y + 0.0415560 * c.z,
            0.0556434 * c.x - 0.2040259 * c.y + 1.0572252 * c.z};
}

SpectrumToRgb::SpectrumToRgb(const std::vector<double>& wavelengths) : weights_(wavelengths.size())
{
    requireAscending(wavelengths);
    Vec3d white(0.0);
    for (int nm = kFirst; nm <= kLast; ++nm) {  // 1 nm: finer than any measured spectrum
        const Vec3d colour = lineColour(nm);
        white += colour;
        const auto above = std::upper_bound(wavelengths.begin(), wavelengths.end(), double(nm));
        const size_t upper = size_t(above - wavelengths.begin());
        if (upper == 0 || upper == wavelengths.size()) {
            weights_[upper == 0 ? 0 : upper - 1] += colour;
            continue;
        }
        const double lower = wavelengths[upper - 1];
        const double blend = (nm - lower) / (wavelengths[upper] - lower);
        weights_[upper - 1] += colour * (1.0 - blend);
        weights_[upper] += colour * blend;
    }
    for (Vec3d& weight : weights_) weight /= white;
}

Vec3d SpectrumToRgb::operator()(const double* spectrum) const
{
    Vec3d rgb(0.0);
    for (size_t i = 0; i < weights_.size(); ++i) rgb += weights_[i] * spectrum[i];
    return rgb;
}

}  // namespace fbrdf
