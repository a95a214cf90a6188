// Rgl.cpp - EPFL's RGL material database, .bsdf (Dupuy and Jakob 2018), isotropic and anisotropic.
// Container: Tensor.h. Fields: theta_i[T], phi_i[P] (radians, of wi, away from the surface; P <= 2
// means isotropic), ndf and sigma over the half sphere, vndf[P, T, H, W], and rgb[P, T, 3, h, w]
// (linear sRGB) or spectra[P, T, n, h, w] with wavelengths[n] in nm. With wm = norm(wi + wo),
//   u(theta) = sqrt(2 theta / pi), v(phi) = (phi + pi) / (2 pi),
//   s = inverse of the vndf warp at (u(theta_m), v(phi_m - phi_i)), v(phi_m) where anisotropic,
//   f cos(theta_o) = max(0, rgb(s)) ndf(u, v) / (4 sigma(u(theta_i), v(phi_i)))
// interpolated over (phi_i, theta_i): the stored value includes the cosine of wo, taken out here.
// A phi_i that covers a half or a quarter of the circle belongs to a material of that symmetry, and
// wi is turned into it. Spectra become linear sRGB (Spectrum.h) before the interpolation; values
// are clamped at 0 after it. From powitacq's code comments and README, and Mitsuba's `measured`.
//
// The samples are the nodes of the file: for each (phi_i, theta_i) the h x w nodes of s, where the
// values are as measured, negatives included.
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Number.h>
#include <fbrdf/base/Text.h>
#include "Formats.h"
#include "formats/RglWarp.h"
#include "SampleRow.h"
#include "Tensor.h"

#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/sources/Spectrum.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace fbrdf {
namespace {

struct Image {
    std::vector<float> texels;
    size_t width = 0, height = 0;

    double operator()(Vec2<double> at) const
    {
        return bilinear(texels.data(), width, height, at.x, at.y);
    }
};

struct RglData {
    std::vector<float> theta,
        phi;  ///< of the slices; slice = phi index x theta count + theta index
    Image ndf, sigma;
    RglWarp vndf;
    std::vector<Vec3f> rgb;  ///< slices x height x width
    size_t width = 0, height = 0;
    bool isotropic = true;
    bool jacobian = true;
    int reduction = 1;  ///< the circle over the range of phi_i: 1, 2 or 4
};

double uOfTheta(double theta)
{
    return std::sqrt(std::max(theta, 0.0) * 2.0 / kPi);
}

double vOfPhi(double phi)
{
    return (phi + kPi) / (2.0 * kPi);
}

struct Direction2 {
    double theta, phi;
};

/// The zenith angle by its chord: acos(z) loses half the digits at the pole.
Direction2 anglesOf(const Vec3d& w)
{
    const double chord = glm::length(w - Vec3d(0.0, 0.0, 1.0));
    return {2.0 * std::asin(std::min(0.5 * chord, 1.0)), std::atan2(w.y, w.x)};
}

GridPosition slicePosition(const std::vector<float>& nodes, double value)
{
    if (nodes.size() < 2) return {};
    const auto above = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, float(value));
    const size_t at = size_t(above - nodes.begin()) - 1;
    const double lower = double(nodes[at]), upper = double(nodes[at + 1]);
    return {at, std::clamp((value - lower) / (upper - lower), 0.0, 1.0)};
}

SliceMix slicesAt(const RglData& data, const Direction2& wi)
{
    const GridPosition phi = slicePosition(data.phi, wi.phi);
    const GridPosition theta = slicePosition(data.theta, wi.theta);
    SliceMix mix;
    for (size_t i = 0; i < 4; ++i) {
        const size_t p = std::min(phi.at + i / 2, data.phi.size() - 1);
        const size_t t = std::min(theta.at + i % 2, data.theta.size() - 1);
        mix.slice[i] = p * data.theta.size() + t;
        mix.weight[i] =
            (i / 2 ? phi.blend : 1.0 - phi.blend) * (i % 2 ? theta.blend : 1.0 - theta.blend);
    }
    return mix;
}

/// Into the part of the circle that was measured, below the x axis, as in Mitsuba's `measured`.
void applySymmetry(int reduction, Vec3d& wo, Vec3d& wi)
{
    if (reduction < 2) return;
    const double turnY = wi.y < 0.0 ? 1.0 : -1.0;
    const double turnX = reduction == 4 ? (wi.x < 0.0 ? 1.0 : -1.0) : turnY;
    for (Vec3d* w : {&wo, &wi}) *w = {turnX * w->x, turnY * w->y, w->z};
}

Vec3d valueAt(const RglData& data, const SliceMix& mix, Vec2<double> s)
{
    const GridPosition x = gridPosition(s.x, data.width), y = gridPosition(s.y, data.height);
    Vec3d value(0.0);
    for (size_t i = 0; i < mix.slice.size(); ++i) {
        const Vec3f* at = data.rgb.data() + (mix.slice[i] * data.height + y.at) * data.width + x.at;
        const Vec3d lower = glm::mix(Vec3d(at[0]), Vec3d(at[1]), x.blend);
        at += data.width;
        value +=
            mix.weight[i] * glm::mix(lower, glm::mix(Vec3d(at[0]), Vec3d(at[1]), x.blend), y.blend);
    }
    return value;
}

/// ndf / (4 sigma cos theta_o): from stored value to f. 0 where it is not defined.
double scaleAt(const RglData& data, Vec2<double> microfacet, const Direction2& wi, double cosine)
{
    if (!data.jacobian) return 1.0 / cosine;
    const double sigma = data.sigma({uOfTheta(wi.theta), vOfPhi(wi.phi)});
    const double scale = data.ndf(microfacet) / (4.0 * sigma * cosine);
    return std::isfinite(scale) ? std::max(scale, 0.0) : 0.0;
}

Vec3d evaluateRgl(const RglData& data, Vec3d wo, Vec3d wi)
{
    if (wo.z <= 0.0 || wi.z <= 0.0) return Vec3d(0.0);
    applySymmetry(data.reduction, wo, wi);
    const Direction2 incident = anglesOf(wi), half = anglesOf(glm::normalize(wo + wi));
    const double v = vOfPhi(data.isotropic ? half.phi - incident.phi : half.phi);
    const Vec2<double> microfacet(uOfTheta(half.theta), v - std::floor(v));
    const SliceMix mix = slicesAt(data, incident);
    const Vec3d value = valueAt(data, mix, data.vndf.invert(mix, microfacet));
    return glm::max(value, Vec3d(0.0)) * scaleAt(data, microfacet, incident, wo.z);
}

/// The pair of a node and its value; rows run over slices, then y, then x.
SampleRow nodeRow(const RglData& data, uint64_t node)
{
    const size_t x = size_t(node) % data.width, y = size_t(node) / data.width % data.height;
    const size_t slice = size_t(node) / data.width / data.height;
    const Direction2 incident = {double(data.theta[slice % data.theta.size()]),
                                 double(data.phi[slice / data.theta.size()])};
    const Vec2<double> microfacet = data.vndf.sample(
        slice, {double(x) / double(data.width - 1), double(y) / double(data.height - 1)});
    const double theta = microfacet.x * microfacet.x * kPi / 2;
    const double phi = (2.0 * microfacet.y - 1.0) * kPi + (data.isotropic ? incident.phi : 0.0);
    const Vec3d wm = directionFromAngles(theta, phi);
    const Vec3d wi = directionFromAngles(incident.theta, incident.phi);
    const Vec3d wo = glm::normalize(2.0 * glm::dot(wm, wi) * wm - wi);
    // The pole (x = 0) is one direction given `height` times, the seam in azimuth one given twice.
    const bool seam = y == 0 || y + 1 == data.height;
    const double weight = x == 0 ? 1.0 / double(data.height) : (seam ? 0.5 : 1.0);
    if (wo.z < kHorizonCosine) return {wo, wi};
    return {wo, wi, Vec3d(data.rgb[size_t(node)]) * scaleAt(data, microfacet, incident, wo.z),
            weight};
}

void requireAscending(const InputFile& file, const std::vector<float>& nodes, const char* name)
{
    for (size_t i = 1; i < nodes.size(); ++i)
        if (!(nodes[i] > nodes[i - 1]))
            throw inputError(
                file,
                Found(std::string(name) + " that does not ascend").expected("ascending angles"));
}

Image readImage(const InputFile& file, const TensorFields& fields, const char* name)
{
    Image image;
    image.texels = readTensor(file, fields, name, {0, 0});
    const std::vector<size_t>& shape = fields.at(name).shape;
    image.height = shape[0];
    image.width = shape[1];
    if (image.width < 2 || image.height < 2)
        throw inputError(file, Found(std::string(name) + " of one node").expected("2 or more"));
    return image;
}

/// rgb or spectra, as rgb a node. `bands` values lie a plane apart for each node.
void readColours(const InputFile& file, const TensorFields& fields, RglData& data)
{
    const bool spectral = fields.count("spectra") != 0;
    const std::string name = spectral ? "spectra" : "rgb";
    const size_t slices = data.phi.size() * data.theta.size();
    std::vector<double> wavelengths;
    if (spectral)
        for (const float nm : readTensor(file, fields, "wavelengths", {0}))
            wavelengths.push_back(double(nm));
    const size_t bands = spectral ? wavelengths.size() : 3;
    const std::vector<float> values =
        readTensor(file, fields, name, {data.phi.size(), data.theta.size(), bands, 0, 0});
    data.height = fields.at(name).shape[3];
    data.width = fields.at(name).shape[4];
    if (data.width < 2 || data.height < 2)
        throw inputError(file, Found(std::string(name) + " of one node").expected("2 or more"));
    const size_t plane = data.width * data.height;
    const SpectrumToRgb toRgb(spectral ? wavelengths : std::vector<double>{500.0});
    std::vector<double> spectrum(bands);
    data.rgb.resize(slices * plane);
    for (size_t node = 0; node < data.rgb.size(); ++node) {
        const float* first = values.data() + node / plane * bands * plane + node % plane;
        for (size_t b = 0; b < bands; ++b) spectrum[b] = double(first[b * plane]);
        data.rgb[node] =
            Vec3f(spectral ? toRgb(spectrum.data()) : Vec3d(spectrum[0], spectrum[1], spectrum[2]));
    }
}

void readWarp(const InputFile& file, const TensorFields& fields, RglData& data)
{
    std::vector<float> density =
        readTensor(file, fields, "vndf", {data.phi.size(), data.theta.size(), 0, 0});
    const std::vector<size_t>& shape = fields.at("vndf").shape;
    if (shape[2] < 2 || shape[3] < 2)
        throw inputError(file, Found("vndf of one node").expected("2 or more"));
    data.vndf = RglWarp(std::move(density), shape[3], shape[2]);
    for (size_t slice = 0; slice < data.vndf.slices(); ++slice)
        if (!data.vndf.isValid(slice))
            throw inputError(file, Found("slice " + std::to_string(slice) +
                                         " of vndf without a positive integral")
                                       .expected("values of at least 0 that are not all 0"));
}

int reductionOf(const InputFile& file, const std::vector<float>& phi)
{
    const double range = double(phi.back()) - double(phi.front());
    const double reduction = std::rint(2.0 * kPi / range);
    if (reduction != 1.0 && reduction != 2.0 && reduction != 4.0)
        throw inputError(file, Found("phi_i over " + numberText(range) + " radians")
                                   .expected("the circle, a half or a quarter of it"));
    return static_cast<int>(reduction);
}

std::shared_ptr<const RglData> readData(const InputFile& file, const TensorFields& fields)
{
    auto data = std::make_shared<RglData>();
    data->theta = readTensor(file, fields, "theta_i", {0});
    data->phi = readTensor(file, fields, "phi_i", {0});
    requireAscending(file, data->theta, "theta_i");
    requireAscending(file, data->phi, "phi_i");
    data->isotropic = data->phi.size() <= 2;
    if (!data->isotropic) data->reduction = reductionOf(file, data->phi);
    data->ndf = readImage(file, fields, "ndf");
    data->sigma = readImage(file, fields, "sigma");
    readWarp(file, fields, *data);
    readColours(file, fields, *data);
    const auto jacobian = fields.find("jacobian");
    if (jacobian != fields.end() && jacobian->second.count > 0)
        data->jacobian = file.bytes()[jacobian->second.offset] != 0;
    return data;
}

/// The file's own description as one line; empty when there is none.
std::string ownDescription(const InputFile& file, const TensorFields& fields)
{
    constexpr int kBytes = 1;  // type of text: unsigned bytes
    const auto found = fields.find("description");
    if (found == fields.end() || found->second.type != kBytes) return "";
    std::string text(
        file.bytes().substr(found->second.offset, std::min<size_t>(found->second.count, 200)));
    for (char& c : text)
        if (!std::isprint(static_cast<unsigned char>(c))) c = ' ';
    return std::string(trimmed(text)) + "; ";
}

}  // namespace

bool isRgl(const InputFile& file)
{
    return isTensorFile(file);
}

Source readRgl(const FileRequest& request)
{
    const InputFile& file = *request.file;
    const TensorFields fields = readTensorFields(file);
    const std::shared_ptr<const RglData> data = readData(file, fields);
    Source source;
    source.isotropic = data->isotropic;
    source.description = ownDescription(file, fields) + "EPFL RGL tensor, " +
                         (fields.count("spectra") ? "spectra to linear sRGB" : "linear sRGB") +
                         ", 1/sr";
    source.evaluate = [data](const Vec3d& wo, const Vec3d& wi) {
        return evaluateRgl(*data, wo, wi);
    };
    source.stream.rows = data->rgb.size();
    source.stream.read = [data](uint64_t first, size_t count, std::vector<Sample>& samples,
                                SampleReport& report) {
        for (uint64_t node = first; node < first + count; ++node)
            addRow(nodeRow(*data, node), samples, report);
    };
    return source;
}

}  // namespace fbrdf
