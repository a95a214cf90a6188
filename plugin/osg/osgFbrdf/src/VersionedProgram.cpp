#include "VersionedProgram.h"

#include "EmbeddedShaders.h"

#include <osg/GLExtensions>

namespace osgFbrdf {

bool hasOsgInputs(const osg::State& state)
{
    if (!state.getUseVertexAttributeAliasing() || !state.getUseModelViewAndProjectionUniforms())
        return false;
    const auto* extensions = osg::GLExtensions::Get(state.getContextID(), false);
    return !extensions || extensions->glslLanguageVersion >= 1.4f;
}

fbrdf::SurfaceInputs surfaceInputs(int glsl)
{
    fbrdf::SurfaceInputs inputs;
    inputs.builtIns = glsl == 120;
    if (!inputs.builtIns) inputs.vertexInputs = fbrdf::osgFbrdfShader("inputs.glsl");
    return inputs;
}

std::string shaderHead(int glsl)
{
    return "#version " + std::to_string(glsl) + "\n" +
           std::string(fbrdf::shaderSnippet("version.glsl"));
}

VersionedProgram::VersionedProgram(const std::string& name, const VersionedShader& vertex,
                                   const VersionedShader& fragment)
    : ofOsgInputs_(new osg::Program)
{
    setName(name);
    ofOsgInputs_->setName(name);
    for (const auto* shader : {&vertex, &fragment}) {
        addShader((*shader)[0]);
        ofOsgInputs_->addShader((*shader)[1]);
    }
}

VersionedProgram::VersionedProgram(const VersionedProgram& other, const osg::CopyOp& op)
    : osg::Program(other, op), ofOsgInputs_(other.ofOsgInputs_)
{
}

void VersionedProgram::bindAttribute(const std::string& name, unsigned int index)
{
    addBindAttribLocation(name, index);
    ofOsgInputs_->addBindAttribLocation(name, index);
}

void VersionedProgram::apply(osg::State& state) const
{
    if (ofOsgInputs_ && hasOsgInputs(state))
        ofOsgInputs_->apply(state);
    else
        osg::Program::apply(state);
}

void VersionedProgram::compileGLObjects(osg::State& state) const
{
    if (ofOsgInputs_ && hasOsgInputs(state))
        ofOsgInputs_->compileGLObjects(state);
    else
        osg::Program::compileGLObjects(state);
}

void VersionedProgram::resizeGLObjectBuffers(unsigned int maxSize)
{
    osg::Program::resizeGLObjectBuffers(maxSize);
    if (ofOsgInputs_) ofOsgInputs_->resizeGLObjectBuffers(maxSize);
}

void VersionedProgram::releaseGLObjects(osg::State* state) const
{
    osg::Program::releaseGLObjects(state);
    if (ofOsgInputs_) ofOsgInputs_->releaseGLObjects(state);
}

}  // namespace osgFbrdf
