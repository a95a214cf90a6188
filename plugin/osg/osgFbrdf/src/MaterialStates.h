// MaterialStates.h - textures, programs and the state sets of passes, for one material: what does
// not change between frames, views and effects. Thread-safe.
#pragma once
#include <fbrdf/brdf/Material.h>
#include <fbrdf/shaders/ShaderSource.h>

#include <osg/Program>
#include <osg/StateSet>
#include <osg/Texture>

#include <OpenThreads/Mutex>

#include <map>
#include <string>
#include <vector>

namespace osgFbrdf {

/// What plans assume of every context (a technique's validate() asks the context): GLSL 1.20,
/// surfaces off screen, and as many uniforms as hardware with GLSL 1.40 has, less what laws.glsl
/// needs where lights have laws.
fbrdf::Capabilities assumedCapabilities(bool laws = false);

/// Where a pass stands: bin number within the effect, its textures, where tangents come from,
/// whether lights have laws of their own (PlainLights.h).
struct PassPlace {
    int bin = 0;
    int firstTextureUnit = 0;
    bool derivedTangents = false;
    bool laws = false;
};

class MaterialStates : public osg::Referenced {
public:
    explicit MaterialStates(const fbrdf::Material& material);

    const fbrdf::Form& form() const { return form_; }
    bool hasSigns() const { return hasSigns_; }
    int textureUnits() const { return static_cast<int>(textures_.size()); }
    /// Program, maps, blending, depth and bin of a pass. The caller adds lights, scales and eye.
    osg::ref_ptr<osg::StateSet> stateOf(const fbrdf::Pass& pass, const PassPlace& place);
    /// The same of the pass that blends fog over the others.
    osg::ref_ptr<osg::StateSet> fogStateOf(int bin);

    void resizeGLObjectBuffers(unsigned int maxSize);
    void releaseGLObjects(osg::State* state);

protected:
    ~MaterialStates() override = default;

private:
    struct Map {
        osg::ref_ptr<osg::Texture> texture;  ///< null: knots in uniforms
        std::vector<osg::ref_ptr<osg::Uniform>> uniforms;
    };
    Map mapOf(int index, const fbrdf::Table& table);
    osg::ref_ptr<osg::Program> programOf(const fbrdf::ProgramSpec& spec, const PassPlace& place);
    void addMaps(osg::StateSet& state, int firstTextureUnit) const;

    fbrdf::Form form_;
    bool hasSigns_ = false;
    std::string name_;
    std::vector<fbrdf::TableEncoding> encodings_;
    std::vector<Map> maps_;         ///< one a table
    std::vector<size_t> textures_;  ///< maps with a texture, in the order of their units
    osg::ref_ptr<osg::Shader> vertex_, derivingVertex_;
    OpenThreads::Mutex mutex_;
    std::map<std::string, osg::ref_ptr<osg::Program>> programs_;  ///< by fragment shader
    osg::ref_ptr<osg::Program> fog_;
    std::map<std::string, osg::ref_ptr<osg::StateSet>> states_;
};

}  // namespace osgFbrdf
