// VertexHook.h - vertex code of the host in all passes of an effect: skinning, instances, wind.
// Passes match depth by EQUAL, so what moves vertices must be in each of them.
#pragma once
#include <map>
#include <string>

namespace osgFbrdf {

/// GLSL that defines
///     void fbrdfVertexHook(inout vec3 position, inout vec3 normal, inout vec4 tangent)
/// in object space, and declares what it reads: attributes by FBRDF_ATTRIBUTE, uniforms, samplers.
/// It is put after the version line, which is 120 or, where contexts have osg::State's inputs, 140;
/// its \#extension lines come first. The fallback and cameras of shadow maps do without.
struct VertexHook {
    std::string glsl = {};                                ///< "": none
    std::map<std::string, unsigned int> attributes = {};  ///< their indices, by name

    bool operator==(const VertexHook& other) const
    {
        return glsl == other.glsl && attributes == other.attributes;
    }
};

/// The skinning of osgAnimation::RigTransformHardware, which sets uniforms and attributes, and
/// whose own program gives way to the effect's. matrices: those of its getMatrixPaletteUniform();
/// attributes: its getNumVertexAttrib(), which are vertex attributes from `firstAttribute` on.
VertexHook skinningHook(unsigned int matrices, unsigned int attributes,
                        unsigned int firstAttribute = 11);

}  // namespace osgFbrdf
