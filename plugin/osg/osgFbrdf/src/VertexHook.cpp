#include <osgFbrdf/VertexHook.h>

#include "EmbeddedShaders.h"

#include <algorithm>

namespace osgFbrdf {

VertexHook skinningHook(unsigned int matrices, unsigned int attributes, unsigned int firstAttribute)
{
    VertexHook hook;
    std::string adds;
    hook.glsl = "#define OSG_FBRDF_MATRICES " + std::to_string(std::max(1u, matrices)) + "\n";
    for (unsigned int i = 0; i < attributes; ++i) {
        const std::string name = "boneWeight" + std::to_string(i);
        hook.attributes[name] = firstAttribute + i;
        hook.glsl += "FBRDF_ATTRIBUTE vec4 " + name + ";\n";
        adds += "    osgFbrdfAddBones(" + name + ", position, normal, tangent.xyz);\n";
    }
    hook.glsl += std::string(fbrdf::osgFbrdfShader("skinning.glsl")) +
                 "\nvoid fbrdfVertexHook(inout vec3 position, inout vec3 normal, inout vec4 "
                 "tangent)\n{\n"
                 "    osgFbrdfPosition = osgFbrdfNormal = osgFbrdfTangent = vec3(0.0);\n" +
                 adds +
                 "    position = osgFbrdfPosition;\n    normal = osgFbrdfNormal;\n"
                 "    tangent.xyz = osgFbrdfTangent;\n}\n";
    return hook;
}

}  // namespace osgFbrdf
