#include "io/TestMaterials.h"

#include <cstring>
#include <random>

namespace fbrdf::test {
namespace {

Form sumForm()
{
    const DiscDomain small = DiscDomain::fitting(7, 1.0), other{12, 0.5, 5.25};
    return {"pqp+s",
            {{"p", small}, {"q", other}, {"s", small}},
            {{{{0, Direction::wo}, {1, Direction::h}, {0, Direction::wi}}},
             {{{2, Direction::h}}},
             {{{1, Direction::h}, {2, Direction::wi}}}}};
}

Form volumeForm()
{
    const Axis h{5, {AxisMap::From::oneMinusCosine, 0.25}}, d{4, {AxisMap::From::cosine, 0.3}},
        one{1, {AxisMap::From::cosine, 1.0}};
    return {"volume",
            {{"V", GridDomain{{h, d, Axis{3, {}}}}}, {"W", GridDomain{{h, one}}}},
            {{{{0, std::vector<Angle>{Angle::theta_h, Angle::theta_d, Angle::theta_i}},
               {1, std::vector<Angle>{Angle::theta_h, Angle::theta_o}}}}}};
}

Form unnamedForm()
{
    const GridDomain grid{{Axis{6, {}}}};
    return {"",
            {{"", grid}, {"", grid, true}, {"ä \"quoted\"\n", grid}},
            {{{{0, std::vector<Angle>{Angle::theta_i}}, {0, std::vector<Angle>{Angle::theta_o}}}},
             {{{1, std::vector<Angle>{Angle::theta_d}}, {2, std::vector<Angle>{Angle::theta_h}}}}}};
}

Form directionsForm()
{
    const DiscDomain disc = DiscDomain::fitting(5, 0.5);
    return {
        "directions",
        {{"u", disc}, {"a", GridDomain{{Axis{4, {}}}}}},
        {{{{0, Direction::d}, {0, Direction::mirror}}},
         {{{0, Direction::combination(1.0, 0.25, -0.5)}, {1, std::vector<Angle>{Angle::phi_d}}}}}};
}

bool sameFloats(const std::vector<float>& a, const std::vector<float>& b)
{
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0);
}

std::string tableDifference(const Table& a, const Table& b)
{
    if (a.name != b.name) return "name";
    if (!sameDomain(a.domain, b.domain)) return "domain";
    if (a.storage != b.storage) return "storage";
    if (a.channels != b.channels) return "channels";
    if (a.lower != b.lower || a.upper != b.upper) return "range";
    if (a.log8.stride != b.log8.stride || a.log8.offset != b.log8.offset ||
        a.log8.start != b.log8.start)
        return "log8";
    return sameFloats(a.texels, b.texels) ? "" : "texels";
}

bool sameKnots(const LobeKnot& a, const LobeKnot& b)
{
    return a.cosine == b.cosine && std::equal(a.lobes.begin(), a.lobes.end(), b.lobes.begin(),
                                              [](const Lobe& x, const Lobe& y) {
                                                  return x.weight == y.weight &&
                                                         x.level == y.level && x.tilt == y.tilt;
                                              });
}

bool sameLobes(const LobeTable& a, const LobeTable& b)
{
    return a.axes == b.axes && a.lobes == b.lobes && a.thetas == b.thetas &&
           a.azimuths == b.azimuths && a.spread == b.spread && a.acrossTangent == b.acrossTangent &&
           a.error == b.error && a.fewerErrors == b.fewerErrors &&
           std::equal(a.knots.begin(), a.knots.end(), b.knots.begin(), b.knots.end(), sameKnots);
}

}  // namespace

std::vector<Form> testForms()
{
    return {formPqp(9, 0.5), formPqpr(8, 1.0, 5), formHdio({7, 4, 6}), sumForm(),
            volumeForm(),    unnamedForm(),       directionsForm()};
}

Material testMaterial(const Form& form, Storage storage, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> logs(-20.0f, 4.0f), linears(0.0f, 1.0f);
    Material material;
    material.form = form;
    material.name = "test " + form.name;
    material.notes = {{"source", "fixed\nsequence ä"}, {"empty", ""}, {"units", "1/sr"}};
    material.errors = {{"log_rms", 0.1}, {"psnr_srgb", 1.0 / 3.0}, {"a b:c", -1e300}};
    int channels = 3;
    for (const TableSpec& spec : form.tables) {
        Table table;
        table.name = spec.name;
        table.domain = spec.domain;
        table.channels = channels;
        const int count = texelCount(spec.domain) * channels;
        for (int i = 0; i < count; ++i)
            table.texels.push_back(isLog(storage) ? logs(random) : linears(random));
        if (storage == Storage::signedHalf)
            for (float& texel : table.texels) texel = 2.0f * texel - 1.0f;
        if (!isLog(storage)) table.storage = Storage::linear8;
        if (storage == Storage::linear8)  // quantized() leaves a table of the storage asked for
            for (float& texel : table.texels) texel = float(int(texel * 255.0f)) / 255.0f;
        material.tables.push_back(quantized(table, storage));
        channels = 4 - channels;
    }
    for (size_t t = 0; t < form.terms.size(); ++t)
        material.scales.emplace_back(linears(random), 1.0f / 3.0f, t == 0 ? 0.0f : 1e-30f);
    return material;
}

LobeTable testLobes(LobeAxes axes)
{
    LobeTable table;
    table.axes = axes;
    const bool isBent = axes == LobeAxes::bent;
    table.lobes = isBent ? 3 : 2;
    table.thetas = 4;
    table.azimuths = isBent ? 3 : 1;
    table.spread = isBent ? 0.125f : 0.0f;
    table.acrossTangent = isBent;
    table.error = 0.0125;
    if (isBent) table.fewerErrors = {0.03125};  // may be missing
    float number = 0.01f;
    const auto next = [&] { return number += 0.013f; };
    for (int i = 0; i < table.thetas * table.azimuths; ++i) {
        LobeKnot knot;
        knot.cosine = {next(), next(), next()};
        const float common = next();
        for (size_t k = 0; k < static_cast<size_t>(table.lobes); ++k) {
            Lobe& lobe = knot.lobes[k];
            lobe.weight = {next(), next(), next()};
            lobe.level = isBent ? common : next();
            lobe.tilt = isBent ? 0.0f : -next();
        }
        table.knots.push_back(knot);
    }
    return table;
}

std::string firstDifference(const Material& a, const Material& b)
{
    if (a.form.name != b.form.name || describe(a.form) != describe(b.form)) return "form";
    if (a.name != b.name) return "name";
    if (a.notes != b.notes) return "notes";
    if (a.errors != b.errors) return "errors";
    if (a.scales != b.scales) return "scales";
    if (a.tables.size() != b.tables.size()) return "number of tables";
    for (size_t k = 0; k < a.tables.size(); ++k) {
        if (a.form.tables[k].name != b.form.tables[k].name ||
            a.form.tables[k].uniform != b.form.tables[k].uniform ||
            !sameDomain(a.form.tables[k].domain, b.form.tables[k].domain))
            return "form of table " + std::to_string(k);
        const std::string difference = tableDifference(a.tables[k], b.tables[k]);
        if (!difference.empty()) return difference + " of table " + std::to_string(k);
    }
    return sameLobes(a.lobes, b.lobes) ? "" : "lobes";
}

}  // namespace fbrdf::test
