#include "FogPass.h"

#include "EmbeddedShaders.h"
#include "InheritedState.h"
#include "PassState.h"

#include <osg/BlendFunc>
#include <osg/Fog>

#include <string>

namespace osgFbrdf {

osg::ref_ptr<osg::Program> fogProgram(osg::Shader* vertex)
{
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName("fbrdf fog");
    program->addShader(vertex);
    program->addShader(
        new osg::Shader(osg::Shader::FRAGMENT, std::string(fbrdf::osgFbrdfShader("fog.frag"))));
    return program;
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
    const auto* fog = dynamic_cast<const osg::Fog*>(inherited.attribute(osg::StateAttribute::FOG));
    const osg::Fog::Mode mode = fog ? fog->getMode() : osg::Fog::EXP;  // OpenGL's default
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->addUniform(new osg::Uniform("osgFbrdfFogMode", mode == osg::Fog::LINEAR ? 0
                                                          : mode == osg::Fog::EXP  ? 1
                                                                                   : 2));
    state->addUniform(new osg::Uniform("osgFbrdfFogRadial", fog && fog->getUseRadialFog()));
    return state;
}

}  // namespace osgFbrdf
