// Arguments.h - what the name of a pseudo file and an option string say. No files, no GL.
#pragma once
#include <string>
#include <vector>

namespace osgFbrdf {

class FactorizedBrdf;

/// MODEL.EXT.[MATERIAL].fbrdf, or MODEL.EXT.NAME.fbrdf with MATERIAL = NAME.fbrdf.
struct PseudoName {
    std::string model;  ///< empty: the file is a material
    std::string material;
};
PseudoName pseudoName(const std::string& file);

/// SCENE.EXT for SCENE.EXT.fbrdf, a scene in its plain form; empty for other names.
std::string plainName(const std::string& file);

struct OptionText {
    std::string name, text;
};
/// What `osgconv --plugin` shows.
std::vector<OptionText> optionTexts();

/// Sets what "exposure=2 technique=batched ..." says; returns what is wrong, one sentence each.
/// Words without '=' are for others.
std::vector<std::string> applyOptions(FactorizedBrdf& effect, const std::string& options);

}  // namespace osgFbrdf
