#include "MaterialInfo.h"

#include "FitJob.h"
#include "LobeInfo.h"
#include "TextTable.h"

#include <fbrdf/base/Assert.h>
#include <fmt/format.h>

#include <algorithm>

namespace fbrdf::tool {
namespace {

// An eighth of the uniform test set. The standard error of the median is then about 1.3 % of it,
// where the text shows two digits, and the command starts in a third of the time.
constexpr size_t kReciprocityPairs = 8192;

struct Range {
    Vec3f least, most;
};

// The range of the stored texels: log2 F, or F for linear8.
Range rangeOf(const Table& table)
{
    Range range{Vec3f(table.texel(0, 0), table.texel(0, 1), table.texel(0, 2)), {}};
    range.most = range.least;
    for (int i = 0; i < texelCount(table.domain); ++i)
        for (int c = 0; c < 3; ++c) {
            range.least[c] = std::min(range.least[c], table.texel(i, c));
            range.most[c] = std::max(range.most[c], table.texel(i, c));
        }
    return range;
}

std::string sizeText(const Domain& domain)
{
    const auto size = domainSize(domain);
    std::string text = fmt::format("{}", size[0]);
    for (size_t d = 1; d < 3; ++d)
        if (size[d] > 1) text += fmt::format("x{}", size[d]);
    return text;
}

std::string domainText(const TableSpec& spec)
{
    if (const auto* disc = std::get_if<DiscDomain>(&spec.domain))
        return fmt::format("disc, gamma {:.4g}", disc->gamma);
    const auto& grid = std::get<GridDomain>(spec.domain);
    return std::string(spec.uniform ? "angles, in uniforms" : "angles") +
           (grid.symmetric ? ", symmetric" : "");
}

// Only materials that were made by our fits have marks of support.
Json unsupportedJson(const Table& table)
{
    return table.unsupported.empty() ? Json() : Json(table.unsupportedCount());
}

std::string unsupportedText(const Table& table)
{
    return table.unsupported.empty() ? "-" : withSeparators(table.unsupportedCount());
}

Json tableJson(const TableSpec& spec, const Table& table)
{
    const Range range = rangeOf(table);
    return {
        {"name", spec.name},
        {"domain", domainText(spec)},
        {"size", domainSize(spec.domain)},
        {"uniform", spec.uniform},
        {"storage", storageName(table.storage)},
        {"channels", table.channels},
        {"bytes", table.bytes()},
        {"unsupported_texels", unsupportedJson(table)},
        {isLog(table.storage) ? "log2_range" : "range", {jsonOf(range.least), jsonOf(range.most)}}};
}

std::string tablesText(const Material& material)
{
    std::vector<std::vector<std::string>> rows{
        {"table", "size", "domain", "storage", "channels", "bytes", "unsupported", "values"}};
    for (size_t t = 0; t < material.tables.size(); ++t) {
        const Table& table = material.tables[t];
        const Range range = rangeOf(table);
        rows.push_back({table.name, sizeText(table.domain), domainText(material.form.tables[t]),
                        storageName(table.storage), fmt::format("{}", table.channels),
                        withSeparators(table.bytes()), unsupportedText(table),
                        fmt::format("{}{:.3g} to {:.3g}", isLog(table.storage) ? "log2 F " : "F ",
                                    std::min({range.least.x, range.least.y, range.least.z}),
                                    std::max({range.most.x, range.most.y, range.most.z}))});
    }
    const Align l = Align::left, r = Align::right;
    return alignedTable({l, r, l, l, r, r, r, l}, rows, 4);
}

std::string scalesText(const Material& material)
{
    std::string text;
    for (const Vec3f& s : material.scales)
        text += fmt::format("{}{:.4g} {:.4g} {:.4g}", text.empty() ? "" : "; ", s.x, s.y, s.z);
    return text;
}

ErrorMap withPrefix(const Material& material, const std::string& prefix)
{
    ErrorMap errors;
    for (const auto& [name, value] : material.errors)
        if (name.compare(0, prefix.size(), prefix) == 0) errors[name.substr(prefix.size())] = value;
    return errors;
}

ErrorMap ofScene(const Material& material)
{
    ErrorMap errors;
    for (const auto& [name, value] : material.errors)
        if (name.find('.') == std::string::npos) errors[name] = value;
    return errors;
}

Json errorsJson(const Material& material)
{
    Json json = jsonOf(ofScene(material));
    json["held_out"] = jsonOf(withPrefix(material, kHeldOutPrefix));
    json["all"] = jsonOf(withPrefix(material, kAllPrefix));
    return json;
}

std::string errorsText(const Material& material)
{
    if (material.errors.empty()) return "";
    return "  errors on the samples of the fit\n" +
           errorTable({withPrefix(material, kHeldOutPrefix), withPrefix(material, kAllPrefix)},
                      {"held out", "all"}) +
           "  pictures and physics\n" + errorTable({ofScene(material)}, {});
}

std::string notesText(const Material& material)
{
    std::vector<std::vector<std::string>> rows;
    for (const auto& [key, value] : material.notes) rows.push_back({key, value});
    return rows.empty() ? "" : "  notes\n" + alignedTable({Align::left, Align::left}, rows, 4);
}

}  // namespace

MaterialInfo materialInfo(const Reflectance& opened, int threads)
{
    FBRDF_ASSERT(opened.material, !=, nullptr);
    return {opened.material, medianReciprocityError(opened.brdf, threads, kReciprocityPairs),
            albedoTable(opened.brdf, threads)};
}

Json jsonOf(const MaterialInfo& info)
{
    const Material& material = *info.material;
    Json tables = Json::array(), scales = Json::array();
    for (size_t t = 0; t < material.tables.size(); ++t)
        tables.push_back(tableJson(material.form.tables[t], material.tables[t]));
    for (const Vec3f& scale : material.scales) scales.push_back(jsonOf(scale));
    return {{"kind", "material"},
            {"name", material.name},
            {"form", material.form.name},
            {"description", describe(material.form)},
            {"isotropic", isIsotropic(material.form)},
            {"lookups_per_light", lookupsPerLight(material.form)},
            {"bytes", materialBytes(material)},
            {"units", "1/sr"},
            {"colorspace", "lin_rec709"},
            {"tables", tables},
            {"scales", scales},
            {"lobes", lobesJson(material.lobes)},
            {"reciprocity", jsonOf(info.reciprocity)},
            {"directional_albedo", jsonOf(info.albedo)},
            {"errors", errorsJson(material)},
            {"notes", material.notes}};
}

std::string textOf(const MaterialInfo& info)
{
    const Material& material = *info.material;
    return "material " + material.name + "\n" +
           alignedTable(
               {Align::left, Align::left},
               {{"form", material.form.name + " = " + describe(material.form)},
                {"kind", std::string(isIsotropic(material.form) ? "isotropic" : "anisotropic") +
                             ", " + fmt::format("{}", lookupsPerLight(material.form)) +
                             " look-ups a light"},
                {"size", withSeparators(materialBytes(material)) + " bytes"},
                {"scale", scalesText(material) + "  (1/sr, linear Rec. 709)"},
                {"environments", lobesText(material.lobes)},
                {"reciprocity",
                 fmt::format("{:.2g}  (median |ln f(a, b) / f(b, a)|)", info.reciprocity)}}) +
           "  tables\n" + tablesText(material) + textOf(info.albedo) + errorsText(material) +
           notesText(material);
}

}  // namespace fbrdf::tool
