// MaterialInfo.h - what `info` reports about a material.
#pragma once
#include "Albedo.h"
#include "Errors.h"
#include "Reflectance.h"

#include <memory>
#include <string>
#include <vector>

namespace fbrdf::tool {

struct MaterialInfo {
    std::shared_ptr<const Material> material;
    double reciprocity = 0.0;  ///< median |ln f(a, b) / f(b, a)| over the uniform set
    std::vector<AlbedoAt> albedo;
};

/// Expects opened.material to be set.
MaterialInfo materialInfo(const Reflectance& opened, int threads);

Json jsonOf(const MaterialInfo& info);
std::string textOf(const MaterialInfo& info);

}  // namespace fbrdf::tool
