#include "FlipMetric.h"

#include <fbrdf/brdf/Conventions.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

// The paper's constants: exponent of colour differences q_c, break point p_c -> p_t of their
// remapping (section 4.1.3), exponent of feature differences q_f and width of the feature detector
// in degrees (section 4.2).
constexpr double kColourExponent = 0.7, kBreakIn = 0.4, kBreakOut = 0.95;
constexpr double kFeatureExponent = 0.5, kFeatureWidth = 0.082;

// ITU-R BT.709 to XYZ, in units of the white point: rows sum to 1, so that white is (1, 1, 1).
Vec3f whiteRelativeXyz(const Vec3f& rgb)
{
    return {(0.4123908f * rgb.x + 0.3575843f * rgb.y + 0.1804808f * rgb.z) / 0.9504559f,
            0.2126390f * rgb.x + 0.7151687f * rgb.y + 0.0721923f * rgb.z,
            (0.0193308f * rgb.x + 0.1191948f * rgb.y + 0.9505322f * rgb.z) / 1.0890578f};
}

Vec3f linearRgb(const Vec3f& xyz)
{
    const float x = xyz.x * 0.9504559f, y = xyz.y, z = xyz.z * 1.0890578f;
    return {3.2409699f * x - 1.5373832f * y - 0.4986108f * z,
            -0.9692436f * x + 1.8759675f * y + 0.0415551f * z,
            0.0556301f * x - 0.2039770f * y + 1.0569715f * z};
}

// CIELab without its cube roots (section 4.1.1): linear, so filtering in it mixes light.
Vec3f ycxczFromXyz(const Vec3f& v)
{
    return {116.0f * v.y - 16.0f, 500.0f * (v.x - v.y), 200.0f * (v.y - v.z)};
}

Vec3f xyzFromYcxcz(const Vec3f& c)
{
    const float y = (c.x + 16.0f) / 116.0f;
    return {y + c.y / 500.0f, y, y - c.z / 200.0f};
}

// CIE 15: the cube root, and its tangent near black.
float labCurve(float t)
{
    constexpr float kDelta = 6.0f / 29.0f;
    return t > kDelta * kDelta * kDelta ? std::cbrt(t)
                                        : t / (3.0f * kDelta * kDelta) + 4.0f / 29.0f;
}

// L*a*b* with a and b shrunk in the dark, the Hunt effect (section 4.1.2).
Vec3f huntLab(const Vec3f& xyz)
{
    const float x = labCurve(xyz.x), y = labCurve(xyz.y), z = labCurve(xyz.z);
    const float lightness = 116.0f * y - 16.0f;
    return {lightness, 0.01f * lightness * 500.0f * (x - y), 0.01f * lightness * 200.0f * (y - z)};
}

// Abasi, Tehran, Fairchild 2020: city block between lightness and chroma, Euclid within chroma.
double hyab(const Vec3f& a, const Vec3f& b)
{
    return static_cast<double>(std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z));
}

// The largest difference within sRGB, between its green and its blue, raised to q_c.
double largestColourDifference()
{
    const Vec3f green = huntLab(whiteRelativeXyz({0.0f, 1.0f, 0.0f}));
    const Vec3f blue = huntLab(whiteRelativeXyz({0.0f, 0.0f, 1.0f}));
    return std::pow(hyab(green, blue), kColourExponent);
}

// Compresses large differences: [0, p_c max] -> [0, p_t], the rest -> [p_t, 1].
double remapped(double difference, double largest)
{
    const double value = std::pow(difference, kColourExponent), limit = kBreakIn * largest;
    if (value < limit) return kBreakOut * value / limit;
    return kBreakOut + (1.0 - kBreakOut) * (value - limit) / (largest - limit);
}

// Contrast sensitivity as a sum of Gaussians a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees (Eq.
// 4, Table 1).
struct Gaussian {
    double a, b;
};
constexpr double kWidestB = 0.04;

// exp(-pi^2 x^2 / b) is a Gaussian of sigma = sqrt(b / 2) / pi degrees.
double sigmaOf(double b, double pixelsPerDegree)
{
    return std::sqrt(0.5 * b) / kPi * pixelsPerDegree;
}

// Weight of one Gaussian in two dimensions, summed over the pixels of the filter.
double massOf(const Gaussian& g, double pixelsPerDegree, int radius)
{
    const double sigma = sigmaOf(g.b, pixelsPerDegree);
    double sum = 0.0;
    for (int x = -radius; x <= radius; ++x) sum += std::exp(-0.5 * x * x / (sigma * sigma));
    return g.a * std::sqrt(kPi / g.b) * sum * sum;
}

Plane filtered(const Plane& plane, const std::vector<Gaussian>& sensitivity, double pixelsPerDegree)
{
    // Three sigma of the widest filter, for all three channels, as the paper does.
    const auto radius = static_cast<int>(std::ceil(3.0 * sigmaOf(kWidestB, pixelsPerDegree)));
    double total = 0.0;
    for (const Gaussian& g : sensitivity) total += massOf(g, pixelsPerDegree, radius);
    Plane sum(plane.width, plane.height);
    for (const Gaussian& g : sensitivity) {
        const Kernel kernel = gaussianKernel(sigmaOf(g.b, pixelsPerDegree), radius);
        const auto share = static_cast<float>(massOf(g, pixelsPerDegree, radius) / total);
        const Plane part = convolved(plane, kernel, kernel);
        for (size_t i = 0; i < sum.values.size(); ++i) sum.values[i] += share * part.values[i];
    }
    return sum;
}

RgbPlanes ycxczPlanes(const RgbPlanes& rgb)
{
    RgbPlanes result = rgb;
    for (size_t i = 0; i < rgb[0].values.size(); ++i) {
        const Vec3f c =
            ycxczFromXyz(whiteRelativeXyz({rgb[0].values[i], rgb[1].values[i], rgb[2].values[i]}));
        for (int k = 0; k < 3; ++k) result[static_cast<size_t>(k)].values[i] = c[k];
    }
    return result;
}

// The picture as the eye sees it: filtered, clamped to the display's colours, in Hunt-adjusted Lab.
std::vector<Vec3f> perceived(const RgbPlanes& ycxcz, double pixelsPerDegree)
{
    const Plane y = filtered(ycxcz[0], {{1.0, 0.0047}}, pixelsPerDegree);
    const Plane cx = filtered(ycxcz[1], {{1.0, 0.0053}}, pixelsPerDegree);
    const Plane cz = filtered(ycxcz[2], {{34.1, kWidestB}, {13.5, 0.025}}, pixelsPerDegree);
    std::vector<Vec3f> lab(y.values.size());
    for (size_t i = 0; i < lab.size(); ++i) {
        const Vec3f rgb = linearRgb(xyzFromYcxcz({y.values[i], cx.values[i], cz.values[i]}));
        lab[i] = huntLab(whiteRelativeXyz(glm::clamp(rgb, 0.0f, 1.0f)));
    }
    return lab;
}

// Positive weights summing to 1 and negative ones to -1.
Kernel balanced(const std::vector<double>& weights)
{
    double positive = 0.0, negative = 0.0;
    for (const double w : weights) (w > 0.0 ? positive : negative) += std::abs(w);
    Kernel kernel;
    for (const double w : weights)
        kernel.push_back(static_cast<float>(w / (w > 0.0 ? positive : negative)));
    return kernel;
}

struct Features {
    Plane edges, points;  ///< magnitudes of first and second derivatives
};

Plane magnitude(const Plane& plane, const Kernel& derivative, const Kernel& smooth)
{
    Plane dx = convolved(plane, derivative, smooth);
    const Plane dy = convolved(plane, smooth, derivative);
    for (size_t i = 0; i < dx.values.size(); ++i)
        dx.values[i] = std::hypot(dx.values[i], dy.values[i]);
    return dx;
}

Features featuresOf(Plane luminance, double pixelsPerDegree)
{
    for (float& y : luminance.values) y = (y + 16.0f) / 116.0f;  // to [0, 1]
    const double sigma = 0.5 * kFeatureWidth * pixelsPerDegree;
    const auto radius = static_cast<int>(std::ceil(3.0 * sigma));
    std::vector<double> first, second;
    for (int x = -radius; x <= radius; ++x) {
        const double g = std::exp(-0.5 * x * x / (sigma * sigma));
        first.push_back(-x * g);
        second.push_back((x * x / (sigma * sigma) - 1.0) * g);
    }
    const Kernel smooth = gaussianKernel(sigma, radius);
    return {magnitude(luminance, balanced(first), smooth),
            magnitude(luminance, balanced(second), smooth)};
}

double featureDifference(const Features& a, const Features& b, size_t i)
{
    const float edges = std::abs(a.edges.values[i] - b.edges.values[i]);
    const float points = std::abs(a.points.values[i] - b.points.values[i]);
    const double largest = static_cast<double>(std::max(edges, points)) / std::sqrt(2.0);
    return std::min(1.0, std::pow(largest, kFeatureExponent));
}

}  // namespace

Plane flipMap(const RgbPlanes& image, const RgbPlanes& reference, double pixelsPerDegree)
{
    const RgbPlanes a = ycxczPlanes(image), b = ycxczPlanes(reference);
    const std::vector<Vec3f> labA = perceived(a, pixelsPerDegree),
                             labB = perceived(b, pixelsPerDegree);
    const Features featuresA = featuresOf(a[0], pixelsPerDegree),
                   featuresB = featuresOf(b[0], pixelsPerDegree);
    const double largest = largestColourDifference();
    Plane result(image[0].width, image[0].height);
    for (size_t i = 0; i < result.values.size(); ++i) {
        const double colour = remapped(hyab(labA[i], labB[i]), largest);
        const double feature = featureDifference(featuresA, featuresB, i);
        result.values[i] = static_cast<float>(std::pow(colour, 1.0 - feature));  // Eq. 10
    }
    return result;
}

}  // namespace fbrdf
