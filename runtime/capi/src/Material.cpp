#include "Boundary.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/io/FormFile.h>
#include <fbrdf/io/MaterialFile.h>

using namespace fbrdf::capi;

namespace fbrdf::capi {
namespace {

Storage storageOf(const fbrdf_table& table)
{
    switch (enumerator(table.storage, FBRDF_STORAGE_SIGNED, "storage")) {
        case FBRDF_STORAGE_FLOAT: return Storage::float32;
        case FBRDF_STORAGE_HALF: return Storage::half;
        case FBRDF_STORAGE_LOG8: return Storage::log8;
        case FBRDF_STORAGE_LINEAR8: return Storage::linear8;
        case FBRDF_STORAGE_SIGNED: return Storage::signedHalf;
    }
    return Storage::float32;
}

/// A storage other than `storage` whose texels mean the same, log2 F or F: quantized() then rounds
/// and does not convert.
Storage unrounded(Storage storage)
{
    if (isLog(storage)) return Storage::float32;
    return storage == Storage::linear8 ? Storage::signedHalf : Storage::linear8;
}

Table tableOf(const TableSpec& spec, const fbrdf_table& given)
{
    const int expected = texelCount(spec.domain);
    if (given.texel_count != static_cast<uint32_t>(expected))
        throw Failure(FBRDF_RESULT_ERROR_ARGUMENT,
                      "table '" + spec.name + "': " +
                          fbrdf::Found(std::to_string(given.texel_count) + " texels")
                              .expected(std::to_string(expected)));
    const uint32_t channels = given.channels == 0 ? 3 : given.channels;
    if (channels != 1 && channels != 3)
        throw Failure(FBRDF_RESULT_ERROR_ARGUMENT,
                      "table '" + spec.name + "': " +
                          fbrdf::Found(std::to_string(channels) + " channels").expected("1 or 3"));
    required(given.texels, ("table '" + spec.name + "'").c_str());
    Table table;
    table.name = spec.name;
    table.domain = spec.domain;
    table.channels = static_cast<int>(channels);
    table.storage = unrounded(storageOf(given));
    table.texels.assign(given.texels,
                        given.texels + static_cast<size_t>(given.texel_count) * channels);
    return table;
}

std::vector<Vec3f> scalesOf(const fbrdf_material_desc& desc, size_t terms)
{
    // Most hosts have their scales in the tables.
    if (desc.scale_count == 0) return std::vector<Vec3f>(terms, Vec3f(1.0f));
    const float* scale = &required(desc.scales, "scales");
    std::vector<Vec3f> scales;
    for (uint32_t i = 0; i < desc.scale_count; ++i, scale += 3)
        scales.emplace_back(scale[0], scale[1], scale[2]);
    return scales;
}

Material materialOf(const fbrdf_material_desc& desc)
{
    Material material;
    material.form = formFromJson(&required(desc.form, "form"), "form");
    if (desc.name) material.name = desc.name;
    const auto given = elements(desc.tables, desc.table_count, desc.table_size, "tables");
    if (given.size() != material.form.tables.size())
        throw Failure(FBRDF_RESULT_ERROR_ARGUMENT,
                      "material: " + fbrdf::Found(std::to_string(given.size()) + " tables")
                                         .expected(std::to_string(material.form.tables.size())));
    for (size_t i = 0; i < given.size(); ++i)
        material.tables.push_back(tableOf(material.form.tables[i], given[i]));
    material.scales = scalesOf(desc, material.form.terms.size());
    validate(material, "material");  // first, because only finite texels can be rounded
    for (size_t i = 0; i < given.size(); ++i)
        material.tables[i] = quantized(material.tables[i], storageOf(given[i]));
    return material;
}

}  // namespace
}  // namespace fbrdf::capi

fbrdf_result fbrdf_material_create(const fbrdf_material_desc* desc, const fbrdf_log* log,
                                   fbrdf_material** out)
{
    return created(log, out,
                   [&] { return new fbrdf_material{materialOf(descriptor(desc, "material"))}; });
}

fbrdf_result fbrdf_material_read(const char* path, const fbrdf_log* log, fbrdf_material** out)
{
    return created(
        log, out, [&] { return new fbrdf_material{fbrdf::readMaterial(&required(path, "path"))}; });
}

fbrdf_result fbrdf_material_read_bytes(const void* bytes, size_t size, const char* where,
                                       const fbrdf_log* log, fbrdf_material** out)
{
    return created(log, out, [&] {
        const std::string whole(&required(static_cast<const char*>(bytes), "bytes"), size);
        return new fbrdf_material{fbrdf::materialFromFileBytes(whole, &required(where, "where"))};
    });
}

fbrdf_result fbrdf_material_evaluate(const fbrdf_material* material, const float wo[3],
                                     const float wi[3], float rgb[3])
{
    // A material belongs to no renderer and so has no log; the result alone reports NULLs.
    return guarded(nullptr, [&] {
        required(wo, "wo");
        required(wi, "wi");
        required(rgb, "rgb");
        const fbrdf::Vec3f f = fbrdf::evaluate<float>(required(material, "material").material,
                                                      fbrdf::Vec3f(wo[0], wo[1], wo[2]),
                                                      fbrdf::Vec3f(wi[0], wi[1], wi[2]));
        for (int k = 0; k < 3; ++k) rgb[k] = f[k];
    });
}

void fbrdf_material_release(fbrdf_material* material)
{
    delete material;
}
