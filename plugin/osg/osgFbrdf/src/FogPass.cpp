#include "FogPass.h"

#include "EmbeddedShaders.h"
#include "InheritedState.h"
#include "PassState.h"

#include <osg/BlendFunc>
#include <osg/Fog>

#include <string>

namespace osgFbrdf {

osg::ref_ptr<VersionedProgram> fogProgram(const VersionedShader& vertex)
{
    return new VersionedProgram(
        "fbrdf fog", vertex, versionedShader(osg::Shader::FRAGMENT, [](int glsl) {
            return shaderHead(glsl) + std::string(fbrdf::osgFbrdfShader("fog.frag"));
        }));
}

osg::ref_ptr<osg::StateSet> fogState(osg::Program* program, int bin)
{
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->setAttributeAndModes(program, kOurs);
    // Alpha is the share of the object that comes through the fog; the alpha of the target stays.
    state->setAttributeAndModes(new osg::BlendFunc(GL_ONE, GL_SRC_ALPHA, GL_ZERO, GL_ONE), kOurs);
    setPlace(*state, fbrdf::Depth::match, bin);
    return state;
}

osg::ref_ptr<osg::StateSet> fogOfScene(const InheritedState& inherited)
{
    if (!inherited.mode(GL_FOG).value_or(false)) return nullptr;
    osg::ref_ptr<const osg::Fog> fog =
        dynamic_cast<const osg::Fog*>(inherited.attribute(osg::StateAttribute::FOG));
    if (!fog) fog = new osg::Fog;  // OpenGL's
    const osg::Fog::Mode mode = static_cast<osg::Fog::Mode>(fog->getMode());
    const osg::Vec4f& colour = fog->getColor();
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->addUniform(
        new osg::Uniform("osgFbrdfFogColour", osg::Vec3f(colour.r(), colour.g(), colour.b())));
    state->addUniform(new osg::Uniform(
        "osgFbrdfFogRange", osg::Vec3f(fog->getDensity(), fog->getStart(), fog->getEnd())));
    state->addUniform(new osg::Uniform("osgFbrdfFogMode", mode == osg::Fog::LINEAR ? 0
                                                          : mode == osg::Fog::EXP  ? 1
                                                                                   : 2));
    state->addUniform(new osg::Uniform("osgFbrdfFogRadial", fog->getUseRadialFog()));
    return state;
}

}  // namespace osgFbrdf
