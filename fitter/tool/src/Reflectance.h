// Reflectance.h - a SOURCE or MATERIAL of the command line, opened for evaluation.
#pragma once
#include <fbrdf/metrics/StandardSphere.h>
#include <fbrdf/sources/OpenSource.h>

#include <memory>
#include <string>

namespace fbrdf::tool {

enum class Precision {
    shader,  ///< materials in float, step by step as the shader does
    exact,   ///< everything in double
};

struct Reflectance {
    Source source;
    std::shared_ptr<const Material> material;  ///< empty unless `source` is a material
    BrdfFunction brdf;                         ///< empty for scattered samples
};

/// Throws what openSource throws.
Reflectance openReflectance(const std::string& spec, const SourceOptions& options,
                            Precision precision);

/// Throws Error(input) when `reflectance` knows only scattered samples.
void requireFunction(const Reflectance& reflectance, const std::string& spec);

/// True where f seems not to change when both directions turn about the normal, at a few pairs.
bool isIsotropic(const BrdfFunction& brdf);

/// The lobes of a material's file, or fitted now: to the material, or to the function.
LobeTable lobesOf(const Reflectance& reflectance, int threads);

/// f of a material as the shader evaluates it; keeps the material alive.
BrdfFunction shaderFunction(std::shared_ptr<const Material> material);

}  // namespace fbrdf::tool
