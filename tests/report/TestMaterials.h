// TestMaterials.h - materials and sources whose reflectance is known in closed form.
#pragma once
#include <fbrdf/brdf/Material.h>
#include <fbrdf/sources/Source.h>

#include <cmath>

namespace fbrdf::test {

/// A product whose tables are all 1: f = value everywhere above the horizon.
inline Material constantMaterial(const Vec3f& value, const Form& form)
{
    Material material;
    material.form = form;
    material.name = "constant";
    for (const TableSpec& spec : form.tables) {
        Table table;
        table.name = spec.name;
        table.domain = spec.domain;
        table.texels.assign(static_cast<size_t>(texelCount(spec.domain)) * 3, 0.0f);
        material.tables.push_back(table);
    }
    material.scales.assign(form.terms.size(), value);
    return material;
}

inline Material constantMaterial(const Vec3f& value)
{
    return constantMaterial(value, formHdio({8, 4, 4}));
}

inline Source lambertianSource(double value)
{
    Source source;
    source.name = "lambertian";
    source.format = "model";
    source.isotropic = true;
    source.evaluate = [value](const Vec3d& wo, const Vec3d& wi) {
        return Vec3d(wo.z > 0.0 && wi.z > 0.0 ? value : 0.0);
    };
    return source;
}

/// Samples in the plane of x and z: light at 30 and 60 degrees, views every 10 degrees, f = value.
inline Source scatteredSource(float value)
{
    Source source;
    source.name = "scattered";
    source.format = "csv";
    source.isotropic = true;
    for (const double theta_i : {30.0, 60.0})
        for (int degrees = -80; degrees <= 80; degrees += 10) {
            const double i = theta_i * kPi / 180.0, o = degrees * kPi / 180.0;
            source.samples.push_back({Vec3f(Vec3d(-std::sin(o), 0.0, std::cos(o))),
                                      Vec3f(Vec3d(std::sin(i), 0.0, std::cos(i))), Vec3f(value),
                                      1.0f});
        }
    source.report.given = source.samples.size() + 2;
    source.report.nonFinite = 2;
    return source;
}

}  // namespace fbrdf::test
