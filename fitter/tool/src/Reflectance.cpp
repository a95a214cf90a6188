#include "Reflectance.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/io/MaterialFile.h>
#include <fbrdf/sources/MaterialSource.h>
#include <fbrdf/sources/OpenSource.h>

#include <optional>
#include <utility>

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
    if (std::optional<Material> material = readIfMaterial(spec)) {
        opened.material = std::make_shared<const Material>(std::move(*material));
        opened.source = sourceOfMaterial(opened.material);
    } else {
        opened.source = openSource(spec, options);
    }
    opened.brdf = opened.material && precision == Precision::shader
                      ? shaderFunction(opened.material)
                      : opened.source.evaluate;
    return opened;
}

void requireFunction(const Reflectance& reflectance, const std::string& spec)
{
    if (!reflectance.brdf)
        throw Error(ErrorKind::input, spec,
                    Found("scattered samples, which have no values in between")
                        .expected("a material or a model (fbrdf fit makes a material of samples)"));
}

}  // namespace fbrdf::tool
