// See FormatPage.h: no header of fbrdf but that one. Every function is a paragraph of the page.
#include "io/FormatPage.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFloatVectorAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfVecAttribute.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace page {
namespace {

using nlohmann::json;

struct Part {
    size_t width = 0, height = 0, channels = 0;
    std::vector<double> texels;  ///< log2 F, or F: x, then lines; channel contiguous
    bool isLog = true;

    double at(size_t index, size_t channel) const
    {
        return texels[index * channels + (channels == 1 ? 0 : channel)];
    }
};

std::string text(const Imf::Header& header, const char* name)
{
    return header.typedAttribute<Imf::StringAttribute>(name).value();
}

/// The three types that a list of floats may have.
std::vector<float> floats(const Imf::Header& header, const char* name)
{
    if (const auto* list = header.findTypedAttribute<Imf::FloatVectorAttribute>(name))
        return list->value();
    if (const auto* triple = header.findTypedAttribute<Imf::V3fAttribute>(name))
        return {triple->value().x, triple->value().y, triple->value().z};
    const Imath::M33f& matrix = header.typedAttribute<Imf::M33fAttribute>(name).value();
    return {&matrix[0][0], &matrix[0][0] + 9};
}

/// Codes of log8 to log2 F.
void addDifferences(const Imf::Header& header, Part& part)
{
    const auto triple = [&](const char* name) {
        return header.typedAttribute<Imf::V3iAttribute>(name).value();
    };
    const Imath::V3i stride = triple("fbrdf:stride"), offset = triple("fbrdf:offset"),
                     start = triple("fbrdf:start");
    const std::vector<float> lower = floats(header, "fbrdf:lower"),
                             upper = floats(header, "fbrdf:upper");
    std::vector<int> sums(part.texels.size());
    for (size_t i = 0; i < part.width * part.height; ++i)
        for (size_t c = 0; c < part.channels; ++c) {
            const int channel = static_cast<int>(c),
                      code = static_cast<int>(part.texels[i * part.channels + c]);
            const size_t back = i % part.width != 0 ? 1 : part.width;
            const int previous = i == 0 ? start[channel] : sums[(i - back) * part.channels + c];
            const int sum = previous + stride[channel] * (offset[channel] + code);
            sums[i * part.channels + c] = sum;
            part.texels[i * part.channels + c] =
                double(lower[c]) + (double(upper[c]) - double(lower[c])) * sum / 65535.0;
        }
}

Part readPart(Imf::MultiPartInputFile& file, int index)
{
    Imf::InputPart input(file, index);
    const Imf::Header& header = input.header();
    const Imath::Box2i window = header.dataWindow();
    Part part;
    part.width = static_cast<size_t>(window.max.x - window.min.x + 1);
    part.height = static_cast<size_t>(window.max.y - window.min.y + 1);
    part.channels = header.channels().findChannel("Y") ? 1 : 3;
    std::vector<float> pixels(part.width * part.height * part.channels);
    Imf::FrameBuffer buffer;
    const size_t stride = part.channels * sizeof(float);
    for (size_t c = 0; c < part.channels; ++c)
        buffer.insert(
            std::string(1, part.channels == 1 ? 'Y' : "RGB"[c]),
            Imf::Slice::Make(Imf::FLOAT, &pixels[c], window, stride, stride * part.width));
    input.setFrameBuffer(buffer);
    input.readPixels(window.min.y, window.max.y);
    part.texels.assign(pixels.begin(), pixels.end());
    const std::string storage = text(header, "fbrdf:storage");
    part.isLog = storage != "linear8" && storage != "signed";
    if (storage == "log8") addDifferences(header, part);
    if (storage == "linear8")
        for (double& texel : part.texels) texel /= 255.0;
    return part;
}

double dot(const Triple& a, const Triple& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Triple normalised(const Triple& v)
{
    const double length = std::sqrt(dot(v, v));
    return length > 0 ? Triple{v[0] / length, v[1] / length, v[2] / length} : Triple{0, 0, 1};
}

struct Pair {
    Triple wo, wi, h;
};

Triple difference(const Pair& p)
{
    const double r = std::hypot(p.h[0], p.h[1]);
    const double x = r > 0 ? p.h[0] / r : 1, y = r > 0 ? p.h[1] / r : 0;
    return {dot(p.wi, {p.h[2] * x, p.h[2] * y, -r}), x * p.wi[1] - y * p.wi[0], dot(p.wi, p.h)};
}

Triple direction(const json& argument, const Pair& p)
{
    if (argument.is_object()) {
        const std::vector<double> w = argument.at("norm");
        Triple sum{};
        for (size_t i = 0; i < 3; ++i) sum[i] = w[0] * p.wi[i] + w[1] * p.wo[i];
        sum[2] += w[2];
        return normalised(sum);
    }
    if (argument == "wi") return p.wi;
    if (argument == "wo") return p.wo;
    if (argument == "h") return p.h;
    if (argument == "d") return difference(p);
    if (argument == "mirror") return {-p.wo[0], -p.wo[1], p.wo[2]};
    throw std::runtime_error("a direction that the page does not know");
}

double cosine(const std::string& angle, const Pair& p)
{
    const double a = 0.5 * std::abs(p.wo[2] - p.wi[2]),
                 b = std::abs(p.h[0] * p.wi[1] - p.h[1] * p.wi[0]);
    double value = 0;
    if (angle == "theta_i") value = p.wi[2];
    if (angle == "theta_o") value = p.wo[2];
    if (angle == "theta_h") value = p.h[2];
    if (angle == "theta_d") value = dot(p.wi, p.h);  // |wi + wo| / 2
    const double folded = a + b > 0 ? a / std::hypot(a, b) : 0;
    if (angle == "phi_d") value = folded;
    const bool isViewHigher = p.wo[2] >= p.wi[2];
    const bool isRight = p.h[0] * p.wi[1] - p.h[1] * p.wi[0] >= 0;
    if (angle == "half_phi_d") value = std::sqrt((1 + (isViewHigher ? folded : -folded)) / 2);
    if (angle == "side_phi_d")
        value = std::sqrt((1 + (isViewHigher == isRight ? folded : -folded)) / 2);
    return std::clamp(value, 0.0, 1.0);
}

Triple discPosition(const json& disc, const Triple& v)
{
    const double denominator = 1 + std::max(v[2], 0.0), size = disc.at("size");
    const double x = v[0] / denominator, y = v[1] / denominator, radius = std::hypot(x, y);
    const double scale = radius > 0 ? disc.at("radius").get<double>() *
                                          std::pow(radius, disc.at("gamma").get<double>() - 1)
                                    : 0;
    return {(size - 1) / 2 + scale * x, (size - 1) / 2 + scale * y, 0};
}

Triple gridPosition(const json& grid, const json& angles, const Pair& p)
{
    Triple position{};
    for (size_t i = 0; i < angles.size(); ++i) {
        const json& axis = grid.at("axes").at(i);
        const double c = cosine(angles[i], p);
        const double u =
            std::pow(axis.at("from") == "cos" ? c : 1 - c, axis.at("exponent").get<double>());
        position[i] = u * (axis.at("size").get<double>() - 1);
    }
    return position;
}

/// Texels along x, y, z.
std::array<size_t, 3> sizeOf(const json& domain)
{
    std::array<size_t, 3> size{1, 1, 1};
    if (domain.contains("disc")) {
        size[0] = size[1] = domain.at("disc").at("size");
        return size;
    }
    const json& axes = domain.at("grid").at("axes");
    for (size_t i = 0; i < axes.size(); ++i) size[i] = axes[i].at("size");
    return size;
}

/// Linear interpolation along each coordinate.
double interpolated(const Part& part, const std::array<size_t, 3>& size, const Triple& position,
                    size_t channel)
{
    double sum = 0;
    for (unsigned corner = 0; corner < 8; ++corner) {
        double weight = 1;
        std::array<size_t, 3> at{};
        for (size_t d = 0; d < 3; ++d) {
            const double p = std::clamp(position[d], 0.0, double(size[d] - 1));
            const size_t low = std::min(static_cast<size_t>(p), size[d] > 1 ? size[d] - 2 : 0);
            const bool upper = corner >> d & 1;
            at[d] = std::min(low + (upper ? 1 : 0), size[d] - 1);
            weight *= upper ? p - double(low) : 1 - (p - double(low));
        }
        if (weight > 0)
            sum += weight * part.at((at[2] * size[1] + at[1]) * size[0] + at[0], channel);
    }
    return sum;
}

double factorValue(const json& factor, const json& form, const std::vector<Part>& parts,
                   const Pair& pair, size_t channel)
{
    const size_t index = factor.at("table");
    const json& domain = form.at("tables").at(index).at("domain");
    const Triple position =
        domain.contains("disc")
            ? discPosition(domain.at("disc"), direction(factor.at("argument"), pair))
            : gridPosition(domain.at("grid"), factor.at("argument"), pair);
    const double value = interpolated(parts[index], sizeOf(domain), position, channel);
    return parts[index].isLog ? std::exp2(value) : value;
}

}  // namespace

Triple evaluateFile(const std::string& path, const Triple& wo, const Triple& wi)
{
    Imf::MultiPartInputFile file(path.c_str(), 0);
    const Imf::Header& first = file.header(0);
    const json form = json::parse(text(first, "fbrdf:form"));
    const std::vector<float> scales = floats(first, "fbrdf:scales");
    std::vector<Part> parts;
    for (int k = 0; k < file.parts(); ++k) parts.push_back(readPart(file, k));
    const Pair pair{wo, wi, normalised({wo[0] + wi[0], wo[1] + wi[1], wo[2] + wi[2]})};
    Triple sum{};
    for (size_t t = 0; t < form.at("terms").size(); ++t)
        for (size_t c = 0; c < 3; ++c) {
            double product = double(scales[3 * t + c]);
            for (const json& factor : form["terms"][t])
                product *= factorValue(factor, form, parts, pair, c);
            sum[c] += product;
        }
    return sum;
}

}  // namespace page
