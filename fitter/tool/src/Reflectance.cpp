#include "Reflectance.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/io/MaterialFile.h>
#include <fbrdf/sources/OpenSource.h>

namespace fbrdf::tool {

BrdfFunction shaderFunction(std::shared_ptr<const Material> material)
{
    return [material = std::move(material)](const Vec3d& wo, const Vec3d& wi) {
        return Vec3d(evaluate<float>(*material, Vec3f(wo), Vec3f(wi)));
    };
}

Reflectance openReflectance(const std::string& spec, const SourceOptions& options,
                            Precision precision)
{
    Reflectance opened;
    opened.source = openSource(spec, options);
    opened.brdf = opened.source.evaluate;
    if (opened.source.format != "material") return opened;
    opened.material = std::make_shared<const Material>(readMaterial(spec));
    if (precision == Precision::shader) opened.brdf = shaderFunction(opened.material);
    return opened;
}

void requireFunction(const Reflectance& reflectance, const std::string& spec)
{
    if (!reflectance.brdf)
        throw Error(ErrorKind::input, spec,
                    "found scattered samples, which have no values in between, expected a material "
                    "or a model (fbrdf fit makes a material of samples)");
}

}  // namespace fbrdf::tool
