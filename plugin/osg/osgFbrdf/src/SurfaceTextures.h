// SurfaceTextures.h - how programs and state sets have the textures of a model (ModelTextures.h).
#pragma once
#include <osgFbrdf/ModelTextures.h>

#include <fbrdf/brdf/Form.h>
#include <fbrdf/shaders/ShaderSource.h>

#include <osg/StateSet>
#include <osg/Texture2D>

#include <string>

namespace osgFbrdf {

/// Different for textures that are used in different ways.
std::string keyOf(const ModelTextures& textures);

/// Adds tint hook, tinted terms and normal map of a program of the form.
void addSurface(fbrdf::SurfaceInputs& inputs, const ModelTextures& textures,
                const fbrdf::Form& form);

/// Textures of one texel that change nothing, for what has none of its own.
class PlainTextures {
public:
    PlainTextures();
    /// Adds them, which those of the model below replace, and the units of all.
    void addTo(osg::StateSet& state, const ModelTextures& textures) const;

private:
    osg::ref_ptr<osg::Texture2D> white_, flat_;
};

}  // namespace osgFbrdf
