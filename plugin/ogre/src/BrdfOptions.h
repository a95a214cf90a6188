// BrdfOptions.h - what a material script says behind `fbrdf`: the options of docs/ogre.md, which
// have the names and values that the plugin for OpenSceneGraph gives them.
#pragma once
#include <fbrdf/plan/Transfer.h>

#include <string>
#include <utility>
#include <vector>

namespace ogreFbrdf {

struct BrdfOptions {
    std::string material;  ///< resource name of a .fbrdf
    float exposure = 1.0f;
    fbrdf::Transfer transfer = fbrdf::Transfer::linear;
    bool diffuse = false;  ///< technique diffuse: the fallback is asked for
    bool preciseFiltering = false;
    std::string normalMap;  ///< resource name of a picture; empty: none
};

/// Sets one option. Returns what is wrong with it, "" where nothing is; the options are then
/// unchanged.
std::string setOption(BrdfOptions& options, const std::string& name, const std::string& value);

/// Names and values of what differs from the default, the material first.
std::vector<std::pair<std::string, std::string>> optionsOf(const BrdfOptions& options);

}  // namespace ogreFbrdf
