// VersionedProgram.h - programs for every context of a scene. Contexts have vertices and matrices
// in OpenGL's own inputs, of GLSL 1.20, or in osg::State's, of GLSL 1.40: core profiles have no
// others. One scene may be drawn in both, so a program has its text in both.
#pragma once
#include <fbrdf/shaders/ShaderSource.h>

#include <osg/Program>
#include <osg/State>

#include <array>
#include <string>

namespace osgFbrdf {

constexpr std::array<int, 2> kShaderVersions{120, 140};

/// True where osg::State replaces OpenGL's inputs by its own (setUseVertexAttributeAliasing,
/// setUseModelViewAndProjectionUniforms), and GLSL 1.40, which programs need there, is not known to
/// be missing.
bool hasOsgInputs(const osg::State& state);

/// Where the programs of a version have their inputs.
fbrdf::SurfaceInputs surfaceInputs(int glsl);

/// The beginning of a shader of this library's own that reads those inputs.
std::string shaderHead(int glsl);

/// A shader in each of kShaderVersions.
using VersionedShader = std::array<osg::ref_ptr<osg::Shader>, kShaderVersions.size()>;

/// source(glsl): its text.
template <class Source>
VersionedShader versionedShader(osg::Shader::Type type, const Source& source)
{
    VersionedShader shader;
    for (size_t i = 0; i < shader.size(); ++i)
        shader[i] = new osg::Shader(type, source(kShaderVersions[i]));
    return shader;
}

/// Itself the program of GLSL 1.20; contexts with osg::State's inputs apply another.
class VersionedProgram : public osg::Program {
public:
    VersionedProgram() = default;
    VersionedProgram(const std::string& name, const VersionedShader& vertex,
                     const VersionedShader& fragment);
    VersionedProgram(const VersionedProgram& other,
                     const osg::CopyOp& op = osg::CopyOp::SHALLOW_COPY);
    META_StateAttribute(osgFbrdf, VersionedProgram, PROGRAM)

    /// For all versions.
    void bindAttribute(const std::string& name, unsigned int index);

    void apply(osg::State& state) const override;
    void compileGLObjects(osg::State& state) const override;
    void resizeGLObjectBuffers(unsigned int maxSize) override;
    void releaseGLObjects(osg::State* state = nullptr) const override;

protected:
    ~VersionedProgram() override = default;

private:
    osg::ref_ptr<osg::Program> ofOsgInputs_;  ///< null in what OSG makes by itself as a default
};

}  // namespace osgFbrdf
