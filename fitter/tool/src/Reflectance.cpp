#include "Reflectance.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/environment/LobeFit.h>
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

bool isIsotropic(const BrdfFunction& f)
{
    const auto at = [](double theta, double phi) {
        return Vec3d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                     std::cos(theta));
    };
    for (const double theta : {0.3, 0.8, 1.2})
        for (const double offset : {0.7, 2.5, 3.1}) {
            const Vec3d here = f(at(theta, 0.0), at(0.9 * theta, offset));
            for (const double turn : {0.4, 1.1, 1.6}) {
                const Vec3d there = f(at(theta, turn), at(0.9 * theta, turn + offset));
                if (glm::length(here - there) > 1e-3 * glm::length(here)) return false;
            }
        }
    return true;
}

LobeTable lobesOf(const Reflectance& reflectance, int threads)
{
    LobeFitOptions options;
    options.threads = threads;
    const auto& material = reflectance.material;
    if (!material) return fitLobes(reflectance.brdf, isIsotropic(reflectance.brdf), options);
    return material->lobes.isEmpty() ? fitLobes(*material, options) : material->lobes;
}

}  // namespace fbrdf::tool
