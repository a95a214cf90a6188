// MaterialStates.h - textures, programs and the state sets of passes, for one material: what does
// not change between frames, views and effects. Thread-safe.
#pragma once
#include "ContextNeeds.h"
#include "LobesOfMaterial.h"
#include "ShadowHook.h"
#include "SurfaceTextures.h"
#include "TextureUnits.h"
#include "VersionedProgram.h"

#include <osgFbrdf/VertexHook.h>

#include <fbrdf/brdf/Material.h>
#include <fbrdf/shaders/ShaderSource.h>

#include <osg/StateSet>
#include <osg/Texture>

#include <OpenThreads/Mutex>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace osgFbrdf {

/// What plans assume of every context (a technique's validate() asks the context): GLSL 1.20,
/// surfaces off screen, and as many uniforms as hardware with GLSL 1.40 has, less what the hooks
/// need. surfaces: RGBA32F, RGBA16F or RGBA8.
fbrdf::Capabilities assumedCapabilities(
    const LightHooks& hooks = {}, fbrdf::ColourFormat surfaces = fbrdf::ColourFormat::rgba32f);

/// What an effect decides of its passes beside the plan.
struct PassInputs {
    TextureUnits units;
    bool derivedTangents = false;
    bool preciseFiltering = false;  ///< in the shader
    LightHooks hooks;
    bool listed = false;  ///< lights come from lists (LightLists.h)
    ModelTextures textures;
    VertexHook vertexHook;
    bool blended = false;  ///< blending, depth and bin are the model's: for a plan of one pass
    fbrdf::ColourFormat surfaces = fbrdf::ColourFormat::rgba32f;  ///< their format
};

/// A plan with one state set for each pass: program, maps, blending, depth and bin (the number of
/// the pass, from 1). Lights, scales, eye and environment come on top of it (FrameStates.h).
struct PlannedPasses {
    fbrdf::Plan plan;
    std::vector<osg::ref_ptr<osg::StateSet>> states;
    ContextLimits needed;  ///< by passes with lobes, shadow maps or lists; nothing without
};

class MaterialStates : public osg::Referenced {
public:
    explicit MaterialStates(const fbrdf::Material& material);

    const fbrdf::Form& form() const { return form_; }
    bool hasSigns() const { return hasSigns_; }
    const fbrdf::Peaks& peaks() const { return peaks_; }  ///< without lights
    int textureUnits() const { return static_cast<int>(textures_.size()); }
    /// The unit of the environment's cube map in a pass that adds lobes: after the maps and the
    /// surface that the pass reads.
    int environmentUnit(const fbrdf::Pass& pass, const TextureUnits& units) const
    {
        return units[textureUnits() + (pass.reads ? 1 : 0)];
    }
    /// The unit of list i of the lights (kListSamplers), in a pass that reads lists.
    int listUnit(const fbrdf::Pass& pass, const TextureUnits& units, size_t i) const
    {
        return units[texturesBeforeLists(pass) + static_cast<int>(i)];
    }
    /// See LobesOfMaterial::find.
    LobesOfMaterial::Table lobes(int most, std::string& whyNot)
    {
        return lobes_.find(most, whyNot);
    }

    /// The plan for the request, or its reason for being none.
    fbrdf::Plan plan(const fbrdf::PlanRequest& request, const PassInputs& inputs) const;
    /// The same with the states of its passes, from the last few that were asked for where they are
    /// among them: most frames ask for what the frame before asked for. Peaks change with every
    /// light, and so do such plans. lobes: from lobes(), where the request lights them.
    std::shared_ptr<const PlannedPasses> passes(const fbrdf::PlanRequest& request,
                                                const PassInputs& inputs,
                                                const fbrdf::LobeTable* lobes = nullptr);
    /// State of the pass that blends fog over the others, which have the inputs.
    osg::ref_ptr<osg::StateSet> fogStateOf(int bin, const PassInputs& inputs);

    void resizeGLObjectBuffers(unsigned int maxSize);
    void releaseGLObjects(osg::State* state);

protected:
    ~MaterialStates() override = default;

private:
    struct Map {
        osg::ref_ptr<osg::Texture> texture;     ///< null: knots in uniforms
        osg::ref_ptr<osg::Texture> unfiltered;  ///< the same image, where a shader filters
        std::vector<osg::ref_ptr<osg::Uniform>> uniforms;
    };
    Map mapOf(int index, const fbrdf::Table& table);
    osg::ref_ptr<osg::StateSet> stateOf(const fbrdf::Pass& pass, int bin, const PassInputs& inputs,
                                        const fbrdf::LobeTable* lobes);
    int texturesBeforeLists(const fbrdf::Pass& pass) const
    {
        return textureUnits() + (pass.reads ? 1 : 0) + (pass.lobes.environment ? 1 : 0);
    }
    void addLists(osg::StateSet& state, const fbrdf::Pass& pass, const PassInputs& inputs) const;
    ContextLimits neededBy(const fbrdf::Pass& pass, const PassInputs& inputs) const;
    fbrdf::SurfaceInputs surfaceOf(const PassInputs& inputs, int glsl) const;
    const VersionedShader& vertexOf(const PassInputs& inputs);
    osg::ref_ptr<osg::Program> programOf(const fbrdf::ProgramSpec& spec, const PassInputs& inputs);
    void addMaps(osg::StateSet& state, const PassInputs& inputs) const;
    void addLobes(osg::StateSet& state, const fbrdf::Pass& pass, const PassInputs& inputs,
                  const fbrdf::LobeTable& lobes) const;

    fbrdf::Form form_;
    bool hasSigns_ = false;
    fbrdf::Peaks peaks_;
    LobesOfMaterial lobes_;
    std::string name_;
    std::vector<fbrdf::TableEncoding> encodings_;
    std::vector<Map> maps_;         ///< one a table
    std::vector<size_t> textures_;  ///< maps with a texture, in the order of their units
    PlainTextures plainTextures_;
    OpenThreads::Mutex mutex_;                                        ///< guards what follows
    std::map<std::string, VersionedShader> vertices_;                 ///< by the key of the inputs
    std::map<std::string, osg::ref_ptr<VersionedProgram>> programs_;  ///< by fragment shader
    std::map<std::string, osg::ref_ptr<osg::StateSet>> states_;
    std::map<std::string, std::shared_ptr<const PlannedPasses>> planned_;
};

}  // namespace osgFbrdf
