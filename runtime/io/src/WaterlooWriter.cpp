#include "Codes.h"
#include "Waterloo.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Number.h>
#include <fbrdf/base/OutputFile.h>
#include <fbrdf/pictures/Png.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

// A map that is warped towards the highlight would lose it in fewer texels; the published maps have
// 64.
constexpr int kMinResampled = 64;

/// The tables of a material that the layout has a place for; null where there is none.
struct Parts {
    const Table *p = nullptr, *q = nullptr, *s = nullptr;
    Vec3f alpha{1.0f}, specular{1.0f};
};

bool looksUp(const Factor& factor, const Direction& direction)
{
    const auto* argument = std::get_if<Direction>(&factor.argument);
    return argument && *argument == direction;
}

const Factor* factorOf(const Term& term, const Direction& direction)
{
    const auto found =
        std::find_if(term.factors.begin(), term.factors.end(),
                     [&](const Factor& factor) { return looksUp(factor, direction); });
    return found == term.factors.end() ? nullptr : &*found;
}

bool matchProduct(const Material& material, size_t index, Parts& parts)
{
    const Term& term = material.form.terms[index];
    const Factor *wo = factorOf(term, Direction::wo), *h = factorOf(term, Direction::h),
                 *wi = factorOf(term, Direction::wi);
    // Factors may stand in any order; the layout has one p for both directions, and one product.
    if (term.factors.size() != 3 || !wo || !h || !wi || wo->table != wi->table || parts.p)
        return false;
    parts.p = &material.tables[static_cast<size_t>(wo->table)];
    parts.q = &material.tables[static_cast<size_t>(h->table)];
    parts.alpha = material.scales[index];
    return true;
}

bool matchSpecular(const Material& material, size_t index, Parts& parts)
{
    const Term& term = material.form.terms[index];
    if (term.factors.size() != 1 || !looksUp(term.factors[0], Direction::h) || parts.s)
        return false;
    parts.s = &material.tables[static_cast<size_t>(term.factors[0].table)];
    parts.specular = material.scales[index];
    return true;
}

Parts partsOf(const Material& material, const std::string& path)
{
    Parts parts;
    for (size_t t = 0; t < material.form.terms.size(); ++t)
        if (!matchProduct(material, t, parts) && !matchSpecular(material, t, parts))
            throw Error(ErrorKind::usage, path,
                        Found("form '" + material.form.name + "' = " + describe(material.form))
                            .expected("p(wo) q(h) p(wi), s(h) or their sum, all over discs: the "
                                      "2001 layout holds nothing else"));
    return parts;
}

Vec3f linearAt(const Table& table, const Vec3d& direction)
{
    const Vec2<double> at = discPosition(std::get<DiscDomain>(table.domain), direction);
    Vec3d value = sample(table, Vec3d(at, 0.0));
    if (isLog(table.storage)) value = {std::exp2(value.x), std::exp2(value.y), std::exp2(value.z)};
    return Vec3f(value);
}

bool isPublishedKind(const Table& table)
{
    const auto& disc = std::get<DiscDomain>(table.domain);
    return table.storage == Storage::linear8 && sameDomain(disc, waterlooDomain(disc.size)) &&
           table.lower == Vec3f(0.0f) && table.upper == Vec3f(1.0f);
}

/// A table's F as float over the layout's domain, not yet rounded to 8 bits, in three channels.
Table resampled(const Table& table)
{
    const auto& disc = std::get<DiscDomain>(table.domain);
    const bool keep = sameDomain(disc, waterlooDomain(disc.size));
    const DiscDomain domain = waterlooDomain(keep ? disc.size : std::max(disc.size, kMinResampled));
    Table result;
    result.name = table.name;
    result.domain = domain;
    result.storage = Storage::linear8;
    for (int y = 0; y < domain.size; ++y)
        for (int x = 0; x < domain.size; ++x) {
            const Vec3f value = linearAt(table, directionFromDiscPosition(domain, {x, y}));
            result.texels.insert(result.texels.end(), {value.x, value.y, value.z});
        }
    return result;
}

Vec3f largest(const Table& table)
{
    Vec3f most(0.0f);
    for (size_t i = 0; i < table.texels.size(); ++i) {
        float& channel = most[static_cast<int>(i % 3)];
        channel = std::max(channel, table.texels[i]);
    }
    return most;
}

void multiply(Table& table, const Vec3f& factor)
{
    for (size_t i = 0; i < table.texels.size(); ++i)
        table.texels[i] *= factor[static_cast<int>(i % 3)];
}

/// The map in 8 bits, filling [0, 1] in every channel, and the factor that this takes out. Maps
/// that are in the published layout already stay as they are.
Table normalized(const Table& table, Vec3f& gauge)
{
    gauge = Vec3f(1.0f);
    if (isPublishedKind(table)) return table;
    Table map = resampled(table);
    const Vec3f most = largest(map);
    for (int c = 0; c < 3; ++c)
        if (most[c] > 0.0f) gauge[c] = most[c];
    multiply(map, 1.0f / gauge);
    return quantized(map, Storage::linear8);
}

Table specularMap(const Parts& parts, const std::string& path)
{
    if (isPublishedKind(*parts.s) && parts.specular == Vec3f(1.0f)) return *parts.s;
    // alpha scales the product only, so the scale of this term goes into its map.
    Table map = resampled(*parts.s);
    multiply(map, parts.specular);
    const Vec3f most = largest(map);
    const float peak = std::max({most.x, most.y, most.z});
    if (peak > 1.0f)
        throw Error(ErrorKind::usage, path,
                    Found("a specular map of up to " + numberText(double(peak)) + " 1/sr")
                        .expected("at most 1: the 2001 layout has no scale for it"));
    return quantized(map, Storage::linear8);
}

// The layout has only colour maps: one channel becomes three equal ones.
std::string pngFromCodes(int size, const std::vector<uint16_t>& codes, const std::string& where)
{
    PngImage image{size, size, 3, 8, codes};
    if (codes.size() == static_cast<size_t>(size) * static_cast<size_t>(size)) {
        image.codes.clear();
        for (const uint16_t code : codes) image.codes.insert(image.codes.end(), 3, code);
    }
    return encodePng(image, where);
}

// Directions of OpenGL's cube map faces (OpenGL 2.1, table 3.21): s along a line, t down the lines.
Vec3d faceDirection(int face, double s, double t)
{
    switch (face) {
        case 0: return {1.0, -t, -s};
        case 1: return {-1.0, -t, s};
        case 2: return {s, 1.0, t};
        case 3: return {s, -1.0, -t};
        case 4: return {s, -t, 1.0};
        default: return {-s, -t, -1.0};
    }
}

// A direction below the horizon becomes the nearest one on it, so that filtering across the horizon
// sees no step.
Vec3d raisedToHorizon(Vec3d direction)
{
    if (direction.z < 0.0) direction.z = 0.0;
    const double length = glm::length(direction);
    return length > 0.0 ? direction / length : Vec3d(1.0, 0.0, 0.0);
}

std::string cubeFace(const Table& map, int face, const std::string& where)
{
    const int size = domainSize(map.domain)[0];
    std::vector<uint16_t> codes;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const double s = (2 * x + 1) / double(size) - 1.0, t = (2 * y + 1) / double(size) - 1.0;
            const Vec3f value = linearAt(map, raisedToHorizon(faceDirection(face, s, t)));
            for (int c = 0; c < 3; ++c)
                codes.push_back(static_cast<uint16_t>(std::lround(value[c] * 255.0f)));
        }
    return pngFromCodes(size, codes, where);
}

void addMap(OutputFiles& files, const Table& map, const std::string& base, int index)
{
    const std::string name = base + "_" + std::to_string(index);
    files.add(name + ".png", pngFromCodes(domainSize(map.domain)[0], codesOfTable(map), name));
    for (int face = 0; face < 6; ++face)
        files.add(name + "_" + std::to_string(face) + ".png", cubeFace(map, face, name));
}

std::string descriptionText(const Material& material, int kind, const Vec3f& alpha)
{
    std::string title = material.name;
    for (char& c : title)
        if (static_cast<unsigned char>(c) < 32) c = ' ';
    const auto gain = material.notes.find("display_gain");
    constexpr int kExact = 9;  // digits that give every float back
    std::string numbers = std::to_string(kind);
    for (int c = 0; c < 3; ++c)
        numbers += (c == 0 ? "\n" : " ") + numberText(double(alpha[c]), kExact);
    return title + "\n" + numbers + "\n" + (gain == material.notes.end() ? "1" : gain->second) +
           "\n";
}

}  // namespace

void writeWaterloo(const Material& material, const std::string& path)
{
    const Parts parts = partsOf(material, path);
    const std::string base = path.substr(0, path.size() - 4);  // without ".txt"
    const int kind = !parts.s ? 0 : parts.p ? 1 : 2;
    OutputFiles files;
    Vec3f alpha = parts.alpha;
    if (parts.p) {
        Vec3f pGauge, qGauge;
        addMap(files, normalized(*parts.p, pGauge), base, 0);
        addMap(files, normalized(*parts.q, qGauge), base, 1);
        alpha *= pGauge * pGauge * qGauge;
    }
    if (parts.s) addMap(files, specularMap(parts, path), base, kind == 1 ? 2 : 0);
    files.add(path, descriptionText(material, kind, alpha));
    files.commit();
}

}  // namespace fbrdf
