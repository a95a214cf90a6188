#include "ContextNeeds.h"

#include "CoreProfile.h"
#include "Surfaces.h"
#include "VersionedProgram.h"

#include <fbrdf/base/Found.h>

#include <osg/GLExtensions>

namespace osgFbrdf {
namespace {

int limitOf(GLenum name)
{
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

}  // namespace

bool readsBuffers(const osg::State& state)
{
    const auto* extensions = osg::GLExtensions::Get(state.getContextID(), false);
    return extensions && extensions->glVersion >= 3.1f && extensions->glslLanguageVersion >= 1.4f;
}

std::string tooFew(const std::string& what, int needed, int limit)
{
    return what + ": " +
           fbrdf::Found(std::to_string(limit)).expected("at least " + std::to_string(needed));
}

ContextLimits limitsOf(osg::State& state)
{
    return {limitOf(GL_MAX_TEXTURE_IMAGE_UNITS),
            limitOf(GL_MAX_FRAGMENT_UNIFORM_COMPONENTS),
            hasOsgInputs(state) ||
                osg::isGLExtensionSupported(state.getContextID(), "GL_ARB_shader_texture_lod"),
            readsBuffers(state) ? limitOf(GL_MAX_TEXTURE_BUFFER_SIZE) : 0,
            drawableFormats(state),
            resolvesSamples(state)};
}

std::string refusalBy(const ContextLimits& context, const ContextLimits& needed)
{
    if (needed.choosesLevels && !context.choosesLevels)
        return fbrdf::Found("no choice of levels in fragment shaders")
            .expected("GL_ARB_shader_texture_lod");
    if (needed.textureUnits > context.textureUnits)
        return tooFew("texture units", needed.textureUnits, context.textureUnits);
    return needed.uniformComponents <= context.uniformComponents
               ? ""
               : tooFew("fragment uniform components", needed.uniformComponents,
                        context.uniformComponents);
}

std::string refusalBy(osg::State& state, const ContextNeeds& needs)
{
    if (!needs.refusal.empty()) return needs.refusal;
    const auto* extensions = state.get<osg::GLExtensions>();
    if (!extensions->isGlslSupported || extensions->glslLanguageVersion < 1.2f) return noGlsl();
    if (const std::string reason = whyNothingIsDrawn(state); !reason.empty()) return reason;
    if (extensions->glVersion < 3.0f &&
        !osg::isGLExtensionSupported(state.getContextID(), "GL_ARB_texture_float"))
        return fbrdf::Found("no float textures").expected("OpenGL 3.0 or GL_ARB_texture_float");
    if (!extensions->isFrameBufferObjectSupported && !needs.withoutSurfaces.empty())
        return needs.withoutSurfaces;
    if (const int limit = limitOf(GL_MAX_TEXTURE_IMAGE_UNITS); needs.textureUnits > limit)
        return tooFew(needs.unitsDescription, needs.textureUnits, limit);
    const int limit = limitOf(GL_MAX_FRAGMENT_UNIFORM_COMPONENTS);
    return needs.uniformComponents <= limit
               ? ""
               : tooFew("fragment uniform components", needs.uniformComponents, limit);
}

}  // namespace osgFbrdf
