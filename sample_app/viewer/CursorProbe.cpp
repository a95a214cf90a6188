#include "CursorProbe.h"

#include <fbrdf/base/Srgb.h>
#include <fbrdf/brdf/HalfDifference.h>

#include <algorithm>
#include <cmath>

namespace fbrdf::viewer {
namespace {

constexpr uint64_t kMostRead = 4000000;
constexpr size_t kMostPlotted = 500;
constexpr double kNoLog = 1e9, kMostStops = 12.0;  // that a map shows

double meanOf(const Vec3d& colour)
{
    return (colour.x + colour.y + colour.z) / 3.0;
}

double azimuthOf(const Vec3d& w)
{
    return std::atan2(w.y, w.x);
}

double zenithOf(const Vec3d& w)
{
    return std::acos(std::clamp(w.z, -1.0, 1.0)) / kDegree;
}

/// w turned about the normal.
Vec3d turnedBy(double angle, const Vec3d& w)
{
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * w.x - s * w.y, s * w.x + c * w.y, w.z};
}

/// Unit, tangential, along wi; x for light along the normal.
Vec3d tangentOf(const Vec3d& wi)
{
    const double length = std::hypot(wi.x, wi.y);
    return length > 1e-9 ? Vec3d(wi.x / length, wi.y / length, 0.0) : Vec3d(1.0, 0.0, 0.0);
}

std::string argumentName(const Argument& argument)
{
    if (const auto* direction = std::get_if<Direction>(&argument)) return directionName(*direction);
    std::string names;
    for (const Angle angle : std::get<std::vector<Angle>>(argument))
        names += (names.empty() ? "" : ", ") + std::string(angleName(angle));
    return names;
}

/// log2 |F|; -kNoLog of 0.
double logTexel(const Table& table, double texel)
{
    if (isLog(table.storage)) return texel;
    return texel == 0.0 ? -kNoLog : std::log2(std::abs(texel));
}

}  // namespace

std::optional<CursorHit> hitAt(const std::vector<scene::Instance>& instances, const gl::View& view,
                               const Vec2<double>& place)
{
    // The picture of the one pixel alone: so many times as large, and moved to the middle.
    constexpr double kPixels = 4096.0;
    glm::dmat4 crop(1.0);
    crop[0][0] = crop[1][1] = kPixels;
    crop[3][0] = kPixels * (1.0 - 2.0 * place.x);
    crop[3][1] = kPixels * (2.0 * place.y - 1.0);
    gl::View cropped = view;
    cropped.projection = glm::mat4(crop * glm::dmat4(view.projection));
    const scene::Fragments fragments = rasterise(instances, cropped, 1, 1);
    const scene::Fragment& seen = fragments.at(0, 0);
    if (!seen.covered()) return std::nullopt;
    const scene::Instance& instance = instances[static_cast<size_t>(seen.instance)];
    const scene::SurfacePoint point =
        surfacePoint(*instance.mesh, scene::ToWorld(instance.model), seen);
    CursorHit hit;
    hit.instance = seen.instance;
    hit.position = point.position;
    hit.frame = shadingFrame(point.normal, point.tangent);
    hit.wo = hit.frame.local(scene::Eye(view).directionFrom(point.position));
    return hit;
}

ProbeLight strongestLight(const CursorHit& hit, const scene::LightSet& lights)
{
    ProbeLight best{{-hit.wo.x, -hit.wo.y, hit.wo.z}, "no light: mirror"};
    double most = 0.0;
    const auto consider = [&](const Vec3d& direction, double irradiance, const std::string& name) {
        const Vec3d wi = hit.frame.local(direction);
        if (!(irradiance * wi.z > most)) return;
        most = irradiance * wi.z;
        best = {wi, name, true};
    };
    for (size_t i = 0; i < lights.lights.size(); ++i) {
        const scene::Incident incident = scene::incidentFrom(lights.lights[i], hit.position);
        consider(incident.direction, meanOf(incident.irradiance), "light " + std::to_string(i + 1));
    }
    if (best.isLit) return best;
    for (size_t i = 0; i < lights.areaLights.size(); ++i) {
        const Vec3d towards = Vec3d(centreOf(lights.areaLights[i])) - hit.position;
        const double distance = glm::length(towards);
        if (!(distance > 0.0)) continue;
        consider(towards / distance,
                 meanOf(Vec3d(lights.areaLights[i].radiance)) / (distance * distance),
                 "area light " + std::to_string(i + 1) + ", centre");
    }
    return best;
}

ProbeAngles anglesOf(const DirectionPair<double>& pair)
{
    const HalfDifference half = halfDifferenceFromPair(pair);
    const double phi = std::remainder(azimuthOf(pair.wo) - azimuthOf(pair.wi), 2.0 * kPi);
    return {zenithOf(pair.wi),      zenithOf(pair.wo),      std::abs(phi) / kDegree,
            half.theta_h / kDegree, half.theta_d / kDegree, half.phi_d / kDegree};
}

Vec3d inPlane(const Vec3d& wi, double thetaDegrees)
{
    const double theta = thetaDegrees * kDegree;
    return -std::sin(theta) * tangentOf(wi) + Vec3d(0.0, 0.0, std::cos(theta));
}

PolarCurve polarCurve(const scene::Brdf& brdf, const Vec3d& wi)
{
    PolarCurve curve;
    if (!(wi.z > 0.0)) return curve;
    for (int degrees = -89; degrees <= 89; ++degrees)
        curve.push_back(
            {static_cast<double>(degrees), std::max(0.0, meanOf(brdf(inPlane(wi, degrees), wi)))});
    return curve;
}

Vec2<double> plotted(const PolarPoint& point, double most)
{
    const double radius = std::cbrt(std::clamp(point.f / most, 0.0, 1.0));
    return {radius * std::sin(point.theta * kDegree), radius * std::cos(point.theta * kDegree)};
}

double mostOf(const std::vector<PolarCurve>& curves)
{
    double most = 1e-9;
    for (const PolarCurve& curve : curves)
        for (const PolarPoint& point : curve) most = std::max(most, point.f);
    return most;
}

PlaneSamples::PlaneSamples(const Source& source) : isotropic_(source.isotropic)
{
    const uint64_t rows =
        source.samples.empty() ? source.stream.rows : uint64_t(source.samples.size());
    const uint64_t stride = 1 + rows / kMostRead;
    uint64_t row = 0;
    forEachBlock(source, [&](const Sample* block, size_t count) {
        for (size_t i = 0; i < count; ++i)
            if (row++ % stride == 0) samples_.push_back(block[i]);
    });
    std::sort(samples_.begin(), samples_.end(),
              [](const Sample& a, const Sample& b) { return a.wi.z > b.wi.z; });
}

PolarCurve PlaneSamples::near(const Vec3d& wi, double tolerance) const
{
    const double theta = zenithOf(wi), off = std::sin(tolerance * kDegree);
    const auto cosineAt = [](double degrees) {
        return static_cast<float>(std::cos(std::clamp(degrees, 0.0, 90.0) * kDegree));
    };
    const auto isHigher = [](const Sample& sample, float cosine) { return sample.wi.z > cosine; };
    const auto first = std::lower_bound(samples_.begin(), samples_.end(),
                                        cosineAt(theta - tolerance), isHigher),
               last =
                   std::lower_bound(first, samples_.end(), cosineAt(theta + tolerance), isHigher);
    const Vec3d tangent = tangentOf(wi), across(-tangent.y, tangent.x, 0.0);
    PolarCurve all;
    for (auto sample = first; sample != last; ++sample) {
        Vec3d wo(sample->wo), light(sample->wi);
        if (isotropic_) {
            const double turn = azimuthOf(tangent) - azimuthOf(light);
            wo = turnedBy(turn, wo);
            light = turnedBy(turn, light);
        }
        if (glm::dot(light, wi) < std::cos(tolerance * kDegree)) continue;
        if (std::abs(glm::dot(wo, across)) > off) continue;
        all.push_back({std::atan2(-glm::dot(wo, tangent), wo.z) / kDegree,
                       std::max(0.0, meanOf(Vec3d(sample->f)))});
    }
    PolarCurve chosen;
    const size_t stride = 1 + all.size() / kMostPlotted;
    for (size_t i = 0; i < all.size(); i += stride) chosen.push_back(all[i]);
    return chosen;
}

std::vector<TexelRead> texelsRead(const Material& material, const DirectionPair<double>& pair)
{
    std::vector<TexelRead> reads;
    if (!(pair.wo.z > 0.0 && pair.wi.z > 0.0)) return reads;
    const PairGeometry<double> geometry(pair);
    for (const Term& term : material.form.terms)
        for (const Factor& factor : term.factors) {
            const Table& table = material.tables[static_cast<size_t>(factor.table)];
            TexelRead read;
            read.table = factor.table;
            read.name = table.name + "(" + argumentName(factor.argument) + ")";
            read.position = texelPosition(table.domain, factor.argument, geometry);
            read.texels = stencilAt(table.domain, read.position);
            const Vec3d value = sample(table, read.position);
            for (int c = 0; c < 3; ++c)
                read.value[c] = isLog(table.storage) ? std::exp2(value[c]) : value[c];
            reads.push_back(read);
        }
    return reads;
}

scene::Image mapPicture(const Table& table, int z)
{
    const auto [width, height, depth] = domainSize(table.domain);
    scene::Image picture(width, height);
    const int first = std::clamp(z, 0, depth - 1) * width * height;
    // The corners of discs, which nothing reads, would decide the scale.
    double most = -kNoLog, least = kNoLog;
    for (int i = 0; i < texelCount(table.domain); ++i)
        for (int c = 0; c < 3 && isReachable(table.domain, i); ++c) {
            const double value = logTexel(table, double(table.texel(i, c)));
            most = std::max(most, value);
            if (value > -kNoLog) least = std::min(least, value);
        }
    least = std::max(least, most - kMostStops);
    for (int i = 0; i < width * height; ++i) {
        float* const pixel = picture.pixel(i % width, i / width);
        pixel[3] = 1.0f;
        if (!isReachable(table.domain, first + i)) continue;
        for (int c = 0; c < 3; ++c) {
            const double value = logTexel(table, double(table.texel(first + i, c)));
            const double share = most > least ? (value - least) / (most - least) : 1.0;
            pixel[c] = static_cast<float>(linearFromSrgb(share));
        }
    }
    return picture;
}

}  // namespace fbrdf::viewer
