// Materials.h - descriptors of the C ABI for materials, and what keeps their arrays alive.
#pragma once
#include <fbrdf/brdf/Material.h>
#include <fbrdf/fbrdf.hpp>

#include "FormJson.h"

#include <string>
#include <vector>

namespace fbrdf::test {

/// A form, its tables and its scales as a host gives them; every field can be made wrong.
struct GivenMaterial {
    std::string form;
    std::vector<std::vector<float>> texels;
    std::vector<fbrdf_table> tables;
    std::vector<float> scales;

    /// The material's own texels and scales, to be rounded to `storage`.
    explicit GivenMaterial(const Material& material, fbrdf_storage storage = FBRDF_STORAGE_FLOAT)
        : form(jsonFromForm(material.form).dump())
    {
        for (const Table& table : material.tables) {
            texels.push_back(table.texels);
            fbrdf_table given{};
            given.texel_count = static_cast<uint32_t>(texelCount(table.domain));
            given.channels = static_cast<uint32_t>(table.channels);
            given.storage = storage;
            tables.push_back(given);
        }
        for (size_t i = 0; i < tables.size(); ++i) tables[i].texels = texels[i].data();
        for (const Vec3f& scale : material.scales)
            scales.insert(scales.end(), {scale.x, scale.y, scale.z});
    }
    GivenMaterial(const GivenMaterial&) = delete;
    GivenMaterial& operator=(const GivenMaterial&) = delete;

    fbrdf_material_desc desc() const
    {
        auto result = abi::describe<fbrdf_material_desc>();
        result.form = form.c_str();
        result.table_count = static_cast<uint32_t>(tables.size());
        result.table_size = sizeof(fbrdf_table);
        result.tables = tables.data();
        result.scale_count = static_cast<uint32_t>(scales.size() / 3);
        result.scales = scales.data();
        return result;
    }
    fbrdf_result create(const fbrdf_log& log, abi::Material& out) const
    {
        const fbrdf_material_desc given = desc();
        return out.create(fbrdf_material_create, &given, &log);
    }
};

/// A material of the form whose texels are all `texel`, log2 F.
inline Material constantMaterial(const Form& form, float texel)
{
    Material material;
    material.form = form;
    for (const TableSpec& spec : form.tables) {
        Table table;
        table.name = spec.name;
        table.domain = spec.domain;
        table.texels.assign(3 * static_cast<size_t>(texelCount(spec.domain)), texel);
        material.tables.push_back(table);
    }
    material.scales.assign(form.terms.size(), Vec3f(1.0f));
    return material;
}

}  // namespace fbrdf::test
