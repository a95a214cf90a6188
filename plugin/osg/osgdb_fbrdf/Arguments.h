// Arguments.h - reads names of pseudo files and option strings. It needs neither files nor GL.
#pragma once
#include <osg/ref_ptr>
#include <osgDB/Options>

#include <string>
#include <vector>

namespace osgFbrdf {

class EnvironmentLight;
class FactorizedBrdf;

/// The material of a part of a model.
struct PartFile {
    std::string part;  ///< name of a node, a state set or an osg::Material
    std::string file;
};

/// Materials of parts, "PART:FILE,PART:FILE", and that of the rest, a word without a colon. In
/// parts and files %20 is a space, %2C a comma, %3A a colon (fbrdf/base/Percent.h). Adds what is
/// wrong to problems.
struct MaterialTable {
    std::string rest;  ///< empty: it keeps its own state
    std::vector<PartFile> parts;
};
MaterialTable materialTable(const std::string& text, std::vector<std::string>& problems);

/// MODEL.EXT.[MATERIAL].fbrdf, or MODEL.EXT.NAME.fbrdf with MATERIAL = NAME.fbrdf.
struct PseudoName {
    std::string model;     ///< empty: the file is a material
    std::string material;  ///< with a colon: a MaterialTable; empty: that of the options alone
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

/// Gives the effect the material of the name, and to the parts of the model those of the name and
/// of the option "materials=PART:FILE,..."; a file that cannot be read gives its own warning.
/// paths: where files are looked for; may be null. Returns what is wrong with the tables.
std::vector<std::string> applyMaterials(FactorizedBrdf& effect, const std::string& name,
                                        const std::string& options, const osgDB::Options* paths);

/// The environment of a string such as "environment=studio environmentRotation=90", null where it
/// names none. paths: where a picture is looked for; may be null. Adds what is wrong to problems.
osg::ref_ptr<EnvironmentLight> environmentOf(const std::string& options,
                                             const osgDB::Options* paths,
                                             std::vector<std::string>& problems);

}  // namespace osgFbrdf
