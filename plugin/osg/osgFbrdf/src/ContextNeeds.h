// ContextNeeds.h - what a technique needs of a context, as a value: contexts are asked while they
// draw, when the effect may already be another one.
#pragma once
#include <osg/State>

#include <string>

namespace osgFbrdf {

struct ContextNeeds {
    std::string refusal;          ///< why no context can; empty: the others decide
    std::string withoutSurfaces;  ///< why one without framebuffer objects cannot; empty: it can
    int textureUnits = 0;
    int uniformComponents = 0;
};

constexpr const char* kNoGlsl = "found no GLSL, expected 1.20";

/// "texture units: found 8, expected at least 9".
std::string tooFew(const std::string& what, int needed, int limit);

/// Why the context, which is current, cannot; empty where it can.
std::string refusalBy(osg::State& state, const ContextNeeds& needs);

}  // namespace osgFbrdf
