#include <fbrdf/fit/AnalyticFactors.h>

#include <fbrdf/base/Assert.h>
#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/sources/Model.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace fbrdf {
namespace {

constexpr double kLobeGamma = 0.5;   // of q's map: texels where the highlight is
constexpr int kAngleKnots = 32;      // knots over theta_i, theta_o of T
constexpr int kCurveKnots = 64;      // of a uniform array over one angle
constexpr double kSmallest = 1e-12;  // a factor's logarithm must be finite
constexpr double kGrazing = 1e-3;    // the knot at the horizon stands for this cosine

Vec3f logOf(const Vec3d& value)
{
    Vec3d log;
    for (int c = 0; c < 3; ++c) log[c] = std::log2(std::max(value[c], kSmallest));
    return Vec3f(log);
}

Table tableOf(const TableSpec& spec)
{
    Table table;
    table.name = spec.name;
    table.domain = spec.domain;
    return table;
}

void append(Table& table, const Vec3d& value)
{
    const Vec3f log = logOf(value);
    table.texels.insert(table.texels.end(), {log.x, log.y, log.z});
}

// A map over directions; `value` of the direction at each texel.
Table discTable(const TableSpec& spec, const std::function<Vec3d(const Vec3d&)>& value)
{
    Table table = tableOf(spec);
    const auto& disc = std::get<DiscDomain>(spec.domain);
    for (int y = 0; y < disc.size; ++y)
        for (int x = 0; x < disc.size; ++x)
            append(table, value(directionFromDiscPosition(disc, Vec2<double>(x, y))));
    return table;
}

// A table over one or two angles; `value` of their cosines.
Table angleTable(const TableSpec& spec, const std::function<Vec3d(double, double)>& value)
{
    Table table = tableOf(spec);
    const auto& axes = std::get<GridDomain>(spec.domain).axes;
    const auto cosineAt = [&](size_t axis, int knot) {
        const double u = static_cast<double>(knot) / (axes[axis].size - 1);
        return std::max(kGrazing, std::cos(angleFromAxisCoordinate(axes[axis].map, u)));
    };
    for (int j = 0; j < (axes.size() > 1 ? axes[1].size : 1); ++j)
        for (int i = 0; i < axes[0].size; ++i)
            append(table, value(cosineAt(0, i), axes.size() > 1 ? cosineAt(1, j) : 1.0));
    return table;
}

// Shadowing varies fastest towards grazing: equal steps of sqrt(cos).
Axis cosineAxis(int size)
{
    return {size, {AxisMap::From::cosine, 0.5}};
}

TableSpec pairTable(const std::string& name)
{
    return {name, GridDomain{{cosineAxis(kAngleKnots), cosineAxis(kAngleKnots)}, true}, false};
}

TableSpec curve(const std::string& name, const Axis& axis)
{
    return {name, GridDomain{{axis}}, true};
}

TableSpec lobeTable(int size)
{
    return {"q", DiscDomain::fitting(size, kLobeGamma), false};
}

const std::vector<Angle> kOfThetaI{Angle::theta_i}, kOfThetaO{Angle::theta_o},
    kOfThetaD{Angle::theta_d}, kBothAngles{Angle::theta_i, Angle::theta_o};

// Ward 1992, Eq. 5: q is the Gaussian, p is 1 / sqrt(cos), and D is the Lambertian.
Material wardFactors(const ModelValues& values, int size)
{
    const double ax = values.at("alpha_x").x, ay = values.at("alpha_y").x;
    Material m;
    m.form.tables = {lobeTable(size), curve("p", cosineAxis(kCurveKnots)),
                     curve("D", cosineAxis(2))};
    m.form.terms = {{{{1, kOfThetaO}, {0, Direction::h}, {1, kOfThetaI}}}, {{{2, kOfThetaI}}}};
    m.tables.push_back(discTable(m.form.tables[0], [=](const Vec3d& h) {
        const double z = std::max(h.z, kGrazing), x = h.x / (ax * z), y = h.y / (ay * z);
        return Vec3d(std::exp(-x * x - y * y));
    }));
    m.tables.push_back(angleTable(
        m.form.tables[1], [](double cosine, double) { return Vec3d(1.0 / std::sqrt(cosine)); }));
    m.tables.push_back(angleTable(m.form.tables[2], [](double, double) { return Vec3d(1.0); }));
    m.scales = {Vec3f(values.at("rho_s") / (4.0 * kPi * ax * ay)), Vec3f(values.at("rho_d") / kPi)};
    return m;
}

// 1 - (1 - cosine / 2)^5
double diffuseShape(double cosine)
{
    return 1.0 - std::pow(1.0 - 0.5 * cosine, 5.0);
}

// Ashikhmin and Shirley 2000, section 2.
Material ashikhminShirleyFactors(const ModelValues& values, int size)
{
    const double nu = values.at("nu").x, nv = values.at("nv").x;
    const Vec3d ks = values.at("ks");
    Material m;
    m.form.tables = {lobeTable(size), curve("r", {kCurveKnots, {}}), pairTable("T"),
                     curve("d", cosineAxis(kCurveKnots))};
    m.form.terms = {{{{0, Direction::h}, {1, kOfThetaD}, {2, kBothAngles}}},
                    {{{3, kOfThetaO}, {3, kOfThetaI}}}};
    m.tables.push_back(discTable(m.form.tables[0], [=](const Vec3d& h) {
        const double s = h.x * h.x + h.y * h.y;
        const double n = s > 0.0 ? (nu * h.x * h.x + nv * h.y * h.y) / s : 0.0;
        return Vec3d(std::pow(std::max(h.z, kGrazing), n));
    }));
    m.tables.push_back(angleTable(m.form.tables[1], [=](double cosine, double) {
        return (ks + (1.0 - ks) * std::pow(1.0 - cosine, 5.0)) / cosine;
    }));
    m.tables.push_back(angleTable(m.form.tables[2],
                                  [](double a, double b) { return Vec3d(1.0 / std::max(a, b)); }));
    m.tables.push_back(angleTable(
        m.form.tables[3], [](double cosine, double) { return Vec3d(diffuseShape(cosine)); }));
    m.scales = {Vec3f(static_cast<float>(std::sqrt((nu + 1.0) * (nv + 1.0)) / (8.0 * kPi))),
                Vec3f(values.at("kd") * (1.0 - ks) * (28.0 / (23.0 * kPi)))};
    return m;
}

using Writer = Material (*)(const ModelValues& values, int size);

// Returns nothing for a model without factors of its own.
Writer writerOf(const std::string& model)
{
    if (model == "ward") return wardFactors;
    if (model == "ashikhmin-shirley") return ashikhminShirleyFactors;
    return nullptr;
}

}  // namespace

bool hasAnalyticFactors(const std::string& spec)
{
    return namesModel(spec) && writerOf(parseModelSpec(spec).model->name);
}

std::optional<Material> analyticFactors(const std::string& spec, int size, Storage storage)
{
    FBRDF_ASSERT(size, >=, 2);
    FBRDF_ASSERT(isLog(storage), ==, true);
    const ModelSpec model = parseModelSpec(spec);
    const Writer writer = writerOf(model.model->name);
    if (!writer) return std::nullopt;
    Material material = writer(model.values, size);
    material.form.name = "analytic";
    for (Table& table : material.tables) table = quantized(table, storage);
    material.name = spec;
    return material;
}

}  // namespace fbrdf
