// Arguments.h - reads names of pseudo files and option strings. It needs neither files nor GL.
#pragma once
#include <osg/ref_ptr>
#include <osgDB/Options>

#include <string>
#include <vector>

namespace osgFbrdf {

class EnvironmentLight;
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
/// The options that `osgconv --plugin` shows.
std::vector<OptionText> optionTexts();

/// Sets the properties of a string such as "exposure=2 technique=batched"; returns what is wrong
/// with it, one sentence each. Words without '=' are left to others.
std::vector<std::string> applyOptions(FactorizedBrdf& effect, const std::string& options);

/// The environment of a string such as "environment=studio environmentRotation=90", null where it
/// names none. paths: where a picture is looked for; may be null. Adds what is wrong to problems.
osg::ref_ptr<EnvironmentLight> environmentOf(const std::string& options,
                                             const osgDB::Options* paths,
                                             std::vector<std::string>& problems);

}  // namespace osgFbrdf
