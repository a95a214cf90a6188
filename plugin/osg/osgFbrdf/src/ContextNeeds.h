// ContextNeeds.h - what a technique and an environment need of a context. They are values, as
// contexts are asked while they draw, when the properties of the effect may already be others.
#pragma once
#include <fbrdf/base/Found.h>
#include <fbrdf/plan/Plan.h>

#include <osg/State>

#include <algorithm>
#include <string>

namespace osgFbrdf {

/// Formats of surfaces that passes can add up in.
struct SurfaceFormats {
    bool rgba32f = false, rgba16f = false, rgba8 = false;
    bool has(fbrdf::ColourFormat format) const
    {
        return format == fbrdf::ColourFormat::rgba32f   ? rgba32f
               : format == fbrdf::ColourFormat::rgba16f ? rgba16f
                                                        : rgba8;
    }
};

/// What a context has, or what passes with an environment need of it.
struct ContextLimits {
    int textureUnits = 0;
    int uniformComponents = 0;
    bool choosesLevels = false;  ///< of cube maps, in fragment shaders
    int bufferTexels = 0;  ///< of a texture that GLSL 1.40 reads from a buffer; 0: there are none
    SurfaceFormats surfaces = {};
    bool resolvesSamples = false;  ///< passes can add up beside a multisampled target
};

inline ContextLimits larger(const ContextLimits& a, const ContextLimits& b)
{
    return {std::max(a.textureUnits, b.textureUnits),
            std::max(a.uniformComponents, b.uniformComponents), a.choosesLevels || b.choosesLevels,
            std::max(a.bufferTexels, b.bufferTexels)};
}

inline ContextLimits smaller(const ContextLimits& a, const ContextLimits& b)
{
    return {std::min(a.textureUnits, b.textureUnits),
            std::min(a.uniformComponents, b.uniformComponents),
            a.choosesLevels && b.choosesLevels,
            std::min(a.bufferTexels, b.bufferTexels),
            SurfaceFormats{a.surfaces.rgba32f && b.surfaces.rgba32f,
                           a.surfaces.rgba16f && b.surfaces.rgba16f,
                           a.surfaces.rgba8 && b.surfaces.rgba8},
            a.resolvesSamples && b.resolvesSamples};
}

/// Of the context, which is current.
ContextLimits limitsOf(osg::State& state);

/// True where the context is known to have buffer textures and GLSL 1.40 to read them, which came
/// with OpenGL 3.1. It need not be current.
bool readsBuffers(const osg::State& state);
/// Texels that every such texture may have.
constexpr int kFewestBufferTexels = 65536;

/// Why a context cannot draw what needs so much; empty where it can.
std::string refusalBy(const ContextLimits& context, const ContextLimits& needed);

struct ContextNeeds {
    std::string refusal;  ///< why no context can draw; empty: the other members decide
    /// Why a context without framebuffer objects cannot draw; empty: it can.
    std::string withoutSurfaces;
    int textureUnits = 0;
    std::string unitsDescription = "texture units";  ///< for a refusal
    int uniformComponents = 0;
};

inline std::string noGlsl()
{
    return fbrdf::Found("no GLSL").expected("1.20");
}

/// "texture units: found 8, expected at least 9".
std::string tooFew(const std::string& what, int needed, int limit);

/// Why the context, which is current, cannot draw; empty where it can.
std::string refusalBy(osg::State& state, const ContextNeeds& needs);

}  // namespace osgFbrdf
