// Capabilities.h - what a GL context can do, as far as plans, shaders and textures depend on it. A
// plain value: the renderer fills it from the context, and a test or a driver workaround may hand
// in another.
#pragma once
#include <optional>

namespace fbrdf {

/// How far a linearly filtered value may be from the exact one. Texel values are in the unit of the
/// texture: [0, 1] for UNORM.
struct FilterPrecision {
    /// The largest error of the weight of a texel along one axis: the value is off by this times
    /// the difference of neighbours. 2^-9 where weights have 8 bits (OpenGL asks for nothing).
    double weight = 0.0;
    /// The error that remains however small the difference is: times the largest |texel|.
    double rounding = 0.0;
};

/// How far a stored colour may be from what a pass gave it, in the last place of the format: steps
/// of UNORM; of floats 2^-10 (RGBA16F) or 2^-23 (RGBA32F), relative to the value. These are what
/// OpenGL grants (4.6, 2.3.5.2 and 17.3.6.1): either neighbour is a correct conversion, and
/// blending may round the source to the format before.
struct StoreRounding {
    double write = 1.0;  ///< without blending
    double blend = 2.0;  ///< of what is added, or of what is multiplied by at most 1
    /// Of RGBA16F, absolute: values below its smallest normal number, 2^-14, may be taken for 0.
    double tiny = 0x1p-14;
};

struct Capabilities {
    int glMajor = 2, glMinor = 1;
    int glsl = 120;  ///< version to write shaders in: 120, 140, 150, 330, 450, or of ES 100, 300
    int maxTextureUnits = 8;     ///< samplers of one fragment shader
    int maxTextureSize = 2048;   ///< texels on a side
    int max3dTextureSize = 256;  ///< texels on a side
    int maxCubeSize = 512;       ///< texels on a side of a face
    bool seamlessCubes = false;  ///< cube maps are filtered across the edges of their faces
    bool textureLod = false;     ///< GLSL 1.20: fragment shaders may choose the level of a texture
    int maxUniformVectors = 64;  ///< vec4 uniforms of a fragment shader: lights, knots and the rest
    bool coreProfile = false;    ///< fixed-function state does not exist
    bool framebufferObjects = false;
    bool floatTextures = false;     ///< half and float textures, linearly filtered
    bool unorm16Textures = true;    ///< which OpenGL ES does not have
    bool softwareSampling = false;  ///< texels are fetched by a CPU, where float ones cost least:
                                    ///< nothing has to be unpacked
    bool floatTargets = false;      ///< RGBA32F is renderable and blendable
    bool halfTargets = false;       ///< RGBA16F is, which OpenGL ES has more often
    bool unorm16Targets = false;    ///< RGBA16 is
    bool vertexArrays = false;
    int maxArrayLayers = 0;       ///< of a texture array; 0: there are none
    bool bufferTextures = false;  ///< and GLSL 1.40 that reads them: lists of lights
    int maxBufferTexels = 65536;  ///< of a buffer texture
    /// Storage buffers that a compute shader of GLSL 4.30 may have; 0: there are none of these.
    int computeBuffers = 0;
    long long maxStorageBytes = 1 << 24;  ///< of a storage buffer
    bool debug = false;                   ///< KHR_debug: labels and groups
    bool clipControl = false;  ///< a projection may leave depths in [0, 1] (glClipControl)
    /// Of all textures; empty: the renderer measures it for each kind that it uses.
    std::optional<FilterPrecision> filter = {};
    /// Of all formats; empty: the renderer measures it for each that it uses.
    std::optional<StoreRounding> rounding = {};

    /// True where a fragment shader can choose the level of a cube map, which environments need.
    bool choosesLevels() const { return glsl == 120 ? textureLod : glsl != 100; }
};

}  // namespace fbrdf
