// ContextNeeds.h - what a technique needs of a context. It is a value, as contexts are asked while
// they draw, when the properties of the effect may already be others.
#pragma once
#include <fbrdf/base/Found.h>

#include <osg/State>

#include <string>

namespace osgFbrdf {

struct ContextNeeds {
    std::string refusal;  ///< why no context can draw; empty: the other members decide
    /// Why a context without framebuffer objects cannot draw; empty: it can.
    std::string withoutSurfaces;
    int textureUnits = 0;
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
