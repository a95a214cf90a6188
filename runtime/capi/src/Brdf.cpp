#include "Boundary.h"
#include "Files.h"

#include <array>
#include <cmath>

namespace fbrdf::capi {
namespace {

constexpr int kLargestSize = 4096;  // texels on a side; far above any fit, below any overflow

int sizeAt(const fbrdf_brdf_desc& desc, int index, int least)
{
    const int size = desc.size[index];
    if (size < least || size > kLargestSize)
        throw Failure(FBRDF_ERROR_ARGUMENT, "brdf: found size[" + std::to_string(index) + "] " +
                                                std::to_string(size) + ", expected " +
                                                std::to_string(least) + " to " +
                                                std::to_string(kLargestSize));
    return size;
}

Form formOf(const fbrdf_brdf_desc& desc)
{
    const double gamma = desc.gamma == 0.0f ? 0.5 : static_cast<double>(desc.gamma);
    switch (enumerator<fbrdf_form>(desc.form, FBRDF_HDIO, "form")) {
        case FBRDF_PQP: return formPqp(sizeAt(desc, 0, 2), gamma);
        case FBRDF_PQPR: return formPqpr(sizeAt(desc, 0, 2), gamma, sizeAt(desc, 1, 2));
        case FBRDF_HDIO:
            return formHdio(sizeAt(desc, 0, 2), sizeAt(desc, 1, 2), sizeAt(desc, 2, 2));
    }
    return {};
}

Table tableOf(const TableSpec& spec, const float* texels)
{
    Table table;
    table.name = spec.name;
    table.domain = spec.domain;
    required(texels, ("table '" + spec.name + "'").c_str());
    table.texels.assign(texels, texels + 3 * static_cast<size_t>(texelCount(spec.domain)));
    return table;
}

}  // namespace

Material materialOf(const fbrdf_brdf_desc& desc)
{
    Material material;
    material.form = formOf(desc);
    if (desc.name) material.name = desc.name;
    if (desc.table_count != material.form.tables.size() || !desc.tables)
        throw Failure(FBRDF_ERROR_ARGUMENT,
                      "brdf: found " + std::to_string(desc.tables ? desc.table_count : 0) +
                          " tables, expected " + std::to_string(material.form.tables.size()));
    for (size_t i = 0; i < material.form.tables.size(); ++i)
        material.tables.push_back(tableOf(material.form.tables[i], desc.tables[i]));
    const Vec3f scale(desc.scale[0], desc.scale[1], desc.scale[2]);
    material.scales = {scale == Vec3f(0.0f) ? Vec3f(1.0f) : scale};
    validate(material, "brdf");
    return material;
}

}  // namespace fbrdf::capi

using namespace fbrdf::capi;

fbrdf_result fbrdf_brdf_create(const fbrdf_brdf_desc* desc, const fbrdf_log* log, fbrdf_brdf** out)
{
    return created(log, out, [&] {
        return new fbrdf_brdf{materialOf(descriptor(desc, sizeof *desc, "brdf"))};
    });
}

fbrdf_result fbrdf_brdf_load(const char* path, const fbrdf_log* log, fbrdf_brdf** out)
{
    return created(log, out, [&] { return new fbrdf_brdf{readFile(&required(path, "path"))}; });
}

fbrdf_result fbrdf_brdf_evaluate(const fbrdf_brdf* brdf, const float wo[3], const float wi[3],
                                 float rgb[3])
{
    return guarded(nullptr, [&] {
        required(wo, "wo");
        required(wi, "wi");
        required(rgb, "rgb");
        const fbrdf::Vec3f f = fbrdf::evaluate<float>(required(brdf, "brdf").material,
                                                      fbrdf::Vec3f(wo[0], wo[1], wo[2]),
                                                      fbrdf::Vec3f(wi[0], wi[1], wi[2]));
        for (int k = 0; k < 3; ++k) rgb[k] = f[k];
    });
}

void fbrdf_brdf_release(fbrdf_brdf* brdf)
{
    delete brdf;
}
