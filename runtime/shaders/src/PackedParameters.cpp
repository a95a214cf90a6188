#include <fbrdf/base/Found.h>
#include <fbrdf/shaders/LobeRows.h>
#include <fbrdf/shaders/PackedParameters.h>

#include <algorithm>

namespace fbrdf {
namespace {

constexpr int kRangeTexels = 2;  // lower, extent

bool sameTable(const TableSpec& a, const TableSpec& b)
{
    return a.uniform == b.uniform && sameDomain(a.domain, b.domain);
}

bool sameTerm(const Term& a, const Term& b)
{
    const auto sameFactor = [](const Factor& x, const Factor& y) {
        return x.table == y.table && x.argument == y.argument;
    };
    return std::equal(a.factors.begin(), a.factors.end(), b.factors.begin(), b.factors.end(),
                      sameFactor);
}

}  // namespace

ParameterLayout parameterLayout(const Form& form)
{
    ParameterLayout layout;
    for (const TableSpec& table : form.tables) {
        layout.tables.push_back(layout.stride);
        layout.stride += table.uniform ? texelCount(table.domain) : kRangeTexels;
    }
    layout.scales = layout.stride;
    layout.stride += static_cast<int>(form.terms.size());
    return layout;
}

int packedLobeStride(const LobeLayout& table)
{
    const LobeShare all{table, 0, table.lobes, true};
    return table.lobes == 0 ? 0 : all.knotVectors() + (table.axes == LobeAxes::bent ? 1 : 0);
}

std::vector<glm::vec4> packedLobeRows(const LobeTable& table)
{
    std::vector<glm::vec4> rows = lobeRows(table, {layoutOf(table), 0, table.lobes, true});
    if (table.axes == LobeAxes::bent) rows.emplace_back(lobeBend(table), 0.0f, 0.0f);
    return rows;
}

bool sameLayout(const Material& a, const Material& b)
{
    const auto sameStorage = [](const Table& x, const Table& y) { return x.storage == y.storage; };
    return std::equal(a.form.tables.begin(), a.form.tables.end(), b.form.tables.begin(),
                      b.form.tables.end(), sameTable) &&
           std::equal(a.form.terms.begin(), a.form.terms.end(), b.form.terms.begin(),
                      b.form.terms.end(), sameTerm) &&
           std::equal(a.tables.begin(), a.tables.end(), b.tables.begin(), b.tables.end(),
                      sameStorage) &&
           layoutOf(a.lobes) == layoutOf(b.lobes);
}

std::string whyNotPacked(const Form& form, const Capabilities& capabilities)
{
    if (!capabilities.bufferTextures || capabilities.glsl < 140)
        return Found("no buffer textures and instances").expected("OpenGL 3.1");
    if (capabilities.maxArrayLayers < 1) return Found("no texture arrays").expected("OpenGL 3.0");
    for (const TableSpec& table : form.tables)
        if (!table.uniform && dimensionCount(table.domain) == 3)
            return Found("table '" + table.name + "' of three dimensions")
                .expected("at most two: there are no arrays of volumes");
    return "";
}

}  // namespace fbrdf
