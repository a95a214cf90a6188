// Capabilities.h - what a GL context can do, as far as plans, shaders and textures depend on it. A
// plain value: the renderer fills it from the context, and a test or a driver workaround may hand
// in another.
#pragma once

namespace fbrdf {

struct Capabilities {
    int glMajor = 2, glMinor = 1;
    int glsl = 120;  ///< version to write shaders in: 120, 140, 150, 330, 450, or of ES 100, 300
    int maxTextureUnits = 8;     ///< samplers of one fragment shader
    int maxTextureSize = 2048;   ///< texels on a side
    int max3dTextureSize = 256;  ///< texels on a side
    int maxCubeSize = 512;       ///< texels on a side of a face
    bool seamlessCubes = false;  ///< cube maps are filtered across the edges of their faces
    int maxUniformVectors = 64;  ///< vec4 uniforms of a fragment shader: lights, knots and the rest
    bool coreProfile = false;    ///< fixed-function state does not exist
    bool framebufferObjects = false;
    bool floatTextures = false;     ///< half and float textures, linearly filtered
    bool unorm16Textures = true;    ///< which OpenGL ES does not have
    bool softwareSampling = false;  ///< texels are fetched by a CPU, where float ones cost least:
                                    ///< nothing has to be unpacked
    bool floatTargets = false;      ///< RGBA32F is renderable and blendable
    bool halfTargets = false;       ///< RGBA16F is, which OpenGL ES has more often
    bool vertexArrays = false;
    int maxArrayLayers = 0;       ///< of a texture array; 0: there are none
    bool bufferTextures = false;  ///< and GLSL 1.40 that reads them: lists of lights
    bool debug = false;           ///< KHR_debug: labels and groups
    bool clipControl = false;     ///< a projection may leave depths in [0, 1] (glClipControl)
};

}  // namespace fbrdf
