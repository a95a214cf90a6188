#include "EnvironmentTexture.h"

#include "RendererObject.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/environment/Prefilter.h>
#include <fbrdf/gl/Environment.h>
#include <fbrdf/gl/Renderer.h>

#include <vtk_glew.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkInformationObjectBaseKey.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderer.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLTexture.h>
#include <vtkShaderProgram.h>
#include <vtkTextureObject.h>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>

#include <dlfcn.h>

#include <algorithm>

namespace {

/// VTK hands out no functions of OpenGL; the library that made its context does.
void* load(void*, const char* name)
{
    using Find = void* (*)(const char*);
    for (const char* finder : {"glXGetProcAddressARB", "eglGetProcAddress"})
        if (void* const symbol = dlsym(RTLD_DEFAULT, finder)) {
            void* const found = reinterpret_cast<Find>(symbol)(name);
            if (found) return found;
        }
    return dlsym(RTLD_DEFAULT, name);
}

/// One level after the other, faces in OpenGL's order.
std::vector<std::vector<fbrdf::Vec3f>> texelsOf(const fbrdf::gl::GpuEnvironment& cube)
{
    std::vector<std::vector<fbrdf::Vec3f>> levels;
    glBindTexture(GL_TEXTURE_CUBE_MAP, cube.texture());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    for (int level = 0; level < cube.levels(); ++level) {
        const auto side = static_cast<size_t>(cube.size() >> level);
        auto& texels = levels.emplace_back(6 * side * side);
        for (GLenum face = 0; face < 6; ++face)
            glGetTexImage(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level, GL_RGB, GL_FLOAT,
                          texels.data() + face * side * side);
    }
    glBindTexture(GL_TEXTURE_CUBE_MAP, 0);
    return levels;
}

void upload(vtkTextureObject& texture, std::vector<std::vector<fbrdf::Vec3f>> levels, int size)
{
    const auto side = static_cast<size_t>(size);
    void* faces[6];
    for (size_t face = 0; face < 6; ++face) faces[face] = levels[0].data() + face * side * side;
    texture.SetInternalFormat(GL_RGBA16F);
    texture.SetFormat(GL_RGB);
    texture.SetDataType(GL_FLOAT);
    texture.SetMinificationFilter(vtkTextureObject::LinearMipmapLinear);
    texture.SetMagnificationFilter(vtkTextureObject::Linear);
    texture.SetMaxLevel(static_cast<int>(levels.size()) - 1);
    const auto width = static_cast<unsigned int>(size);
    texture.CreateCubeFromRaw(width, width, 3, VTK_FLOAT, faces);
    texture.Activate();
    for (size_t level = 1; level < levels.size(); ++level) {
        const size_t smaller = side >> level;
        for (GLenum face = 0; face < 6; ++face)
            glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, static_cast<GLint>(level),
                         GL_RGBA16F, static_cast<GLsizei>(smaller), static_cast<GLsizei>(smaller),
                         0, GL_RGB, GL_FLOAT, levels[level].data() + face * smaller * smaller);
    }
    texture.Deactivate();
}

/// Texels as they are: anisotropic filtering takes several even where one level is asked for.
class Unfiltered {
public:
    explicit Unfiltered(vtkTextureObject& texture)
        : texture_(texture), before_(texture.GetMaximumAnisotropicFiltering())
    {
        set(1.0f);
    }
    ~Unfiltered() { set(before_); }
    Unfiltered(const Unfiltered&) = delete;
    Unfiltered& operator=(const Unfiltered&) = delete;

private:
    void set(float anisotropy)
    {
        texture_.SetMaximumAnisotropicFiltering(anisotropy);
        texture_.Bind();
    }

    vtkTextureObject& texture_;
    float before_;
};

glm::dvec3 toVec3(const double* v)
{
    return {v[0], v[1], v[2]};
}

/// From directions of the eye to those of the picture. Of latitude and longitude VTK's middle
/// column is at +x of the environment, the runtime's at -z, and the first row is the lower edge.
glm::mat3 toEnvironment(vtkOpenGLRenderer& renderer, bool isCube)
{
    const glm::dmat4 view = glm::transpose(
        glm::make_mat4(renderer.GetActiveCamera()->GetModelViewTransformMatrix()->GetData()));
    const glm::dvec3 up = toVec3(renderer.GetEnvironmentUp()),
                     right = toVec3(renderer.GetEnvironmentRight()), front = glm::cross(right, up);
    const glm::dmat3 fromWorld =
        glm::transpose(isCube ? glm::dmat3(right, up, front) : glm::dmat3(front, -up, -right));
    return glm::mat3(fromWorld * glm::transpose(glm::dmat3(view)));
}

}  // namespace

vtkStandardNewMacro(vtkFbrdfEnvironmentTexture);
vtkInformationKeyMacro(vtkFbrdfEnvironmentTexture, ENVIRONMENT, ObjectBase);

vtkFbrdfEnvironmentTexture::vtkFbrdfEnvironmentTexture() = default;
vtkFbrdfEnvironmentTexture::~vtkFbrdfEnvironmentTexture() = default;

bool vtkFbrdfEnvironmentTexture::isOn(vtkRenderer& renderer)
{
    return renderer.GetUseImageBasedLighting() && renderer.GetEnvironmentTexture();
}

vtkFbrdfEnvironmentTexture& vtkFbrdfEnvironmentTexture::in(vtkRenderer& renderer)
{
    return fbrdf::vtk::objectOf<vtkFbrdfEnvironmentTexture>(renderer, *ENVIRONMENT());
}

vtkFbrdfEnvironmentTexture& vtkFbrdfEnvironmentTexture::of(vtkOpenGLRenderer& renderer)
{
    auto& environment = in(renderer);
    environment.update(renderer);
    return environment;
}

bool vtkFbrdfEnvironmentTexture::isCurrent(vtkOpenGLRenderer& renderer) const
{
    vtkTexture* const picture = renderer.GetEnvironmentTexture();
    const bool isLost = whyNot_.empty() && texture_->GetHandle() == 0;
    return picture == picture_ && window_ == renderer.GetRenderWindow() && !isLost &&
           madeSize_ == faceSize_ && picture->GetMTime() <= time_ &&
           (!picture->GetInput() || picture->GetInput()->GetMTime() <= time_);
}

void vtkFbrdfEnvironmentTexture::update(vtkOpenGLRenderer& renderer)
{
    if (isCurrent(renderer)) return;
    vtkTexture* const picture = renderer.GetEnvironmentTexture();
    picture_ = picture;
    window_ = vtkOpenGLRenderWindow::SafeDownCast(renderer.GetRenderWindow());
    madeSize_ = faceSize_;
    whyNot_.clear();
    try {
        make(renderer, *picture);
    } catch (const std::exception& error) {
        whyNot_ = error.what();
    }
    time_ = std::max<unsigned long long>(picture->GetMTime(),
                                         picture->GetInput() ? picture->GetInput()->GetMTime() : 0);
}

void vtkFbrdfEnvironmentTexture::make(vtkOpenGLRenderer& renderer, vtkTexture& picture)
{
    picture.Render(&renderer);
    auto* const loaded = vtkOpenGLTexture::SafeDownCast(&picture);
    vtkTextureObject* const source = loaded ? loaded->GetTextureObject() : nullptr;
    if (!source || source->GetHandle() == 0)
        throw fbrdf::Error(fbrdf::ErrorKind::input, "environment",
                           fbrdf::Found("an empty texture").expected("a picture"));
    isCube_ = picture.GetCubeMap();
    fbrdf::gl::RendererOptions options;
    options.load = load;
    options.debugLabels = false;
    fbrdf::gl::Renderer drawing(options);
    source->Activate();
    const Unfiltered texels(*source);
    const auto cube = drawing.createEnvironment(
        fbrdf::gl::HostEnvironment{source->GetHandle(), isCube_}, {faceSize_, false});
    picture.PostRender(&renderer);
    size_ = cube->size();
    texture_->SetContext(window_);
    upload(*texture_, texelsOf(*cube), size_);
}

void vtkFbrdfEnvironmentTexture::setUniforms(vtkShaderProgram& program, vtkOpenGLRenderer& renderer,
                                             float exposure)
{
    program.SetUniformi("fbrdfEnvironment", texture_->GetTextureUnit());
    glm::mat3 turn = toEnvironment(renderer, isCube_);
    program.SetUniformMatrix3x3("fbrdfToEnvironment", glm::value_ptr(turn));
    const float offset = static_cast<float>(fbrdf::cubeLevelOf(0.0, size_));
    const float scale[] = {exposure, exposure, exposure, offset};
    program.SetUniform4f("fbrdfEnvironmentScale", scale);
}
