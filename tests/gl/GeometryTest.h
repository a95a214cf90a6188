// GeometryTest.h - the fixture of tests of the host's geometry, and the objects that they draw.
#pragma once
#include <gtest/gtest.h>

#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "support/gl/CompareImages.h"
#include "support/gl/GlTest.h"
#include "support/gl/Reference.h"

#include <cmath>

namespace fbrdf::test {

constexpr int kSize = 48;
// The tolerance against the reference, as in ImageGLTest.
constexpr double kAgainstReference = 1e-4;
// The same geometry comes from other float operations, in tables of noise.
constexpr double kSameGeometry = 5e-4;
// Derivatives are differences of neighbouring pixels and have 24 bits less those of coordinates.
constexpr double kDerived = 5e-3;
// Where one thing is wrong, the picture is far off.
constexpr double kNoticed = 0.1;

/// A material that is not symmetric in any direction of the tangent frame.
inline Material brushed()
{
    return noiseMaterial(formPqpr(16, 0.5, 12), Storage::half);
}

/// [-1, 1]^2 at z = 0; tangents turned by `turn`, texture coordinates along them.
inline gl::MeshData planeMesh(float turn, float handedness)
{
    gl::MeshData mesh;
    const Vec3f t(std::cos(turn), std::sin(turn), 0.0f), s(-t.y, t.x, 0.0f);
    for (const float y : {-1.0f, 1.0f})
        for (const float x : {-1.0f, 1.0f}) {
            const Vec3f place(x, y, 0.0f);
            mesh.positions.push_back(place);
            mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
            mesh.tangents.push_back(t);
            mesh.handedness.push_back(handedness);
            mesh.textureCoordinates.emplace_back(0.5f + 0.5f * glm::dot(place, t),
                                                 0.5f + 0.5f * handedness * glm::dot(place, s));
        }
    mesh.indices = {0, 1, 3, 0, 3, 2};
    return mesh;
}

inline gl::MeshData transformed(gl::MeshData mesh, const glm::mat4& matrix)
{
    const glm::mat3 linear(matrix), normal(glm::inverseTranspose(linear));
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        mesh.positions[i] = Vec3f(matrix * glm::vec4(mesh.positions[i], 1.0f));
        mesh.normals[i] = normal * mesh.normals[i];
        mesh.tangents[i] = linear * mesh.tangents[i];
    }
    if (glm::determinant(linear) < 0.0f) mesh.handedness.assign(mesh.positions.size(), -1.0f);
    return mesh;
}

/// A plane that fills the target, one pixel a texel of a map as large.
inline gl::View mapView()
{
    gl::View view;
    view.view = glm::translate(glm::mat4(1.0f), Vec3f(0.0f, 0.0f, -4.0f));
    view.projection = glm::ortho(-1.0f, 1.0f, -1.0f, 1.0f, 1.0f, 10.0f);
    return view;
}

class Geometry : public RendererTest {
protected:
    void TearDown() override
    {
        if (map_ != 0) gl().DeleteTextures(1, &map_);
        RendererTest::TearDown();
    }

    struct Object {
        gl::MeshData mesh;
        glm::mat4 model{1.0f};
        const gl::GpuHooks* hooks = nullptr;
        uint32_t normalMap = 0;
    };
    Drawn draw(const Material& material, const Object& object, const gl::View& view = mapView(),
               const gl::DrawOptions& options = {}, std::vector<Light> lights = testLights(6))
    {
        const auto gpu = exactMaterial(*renderer_, material);
        const auto mesh = renderer_->createMesh(object.mesh);
        return drawItems(*renderer_, kSize, view,
                         {{gpu.get(), mesh.get(), object.model, object.hooks, object.normalMap}},
                         lights, options);
    }

    std::vector<double> reference(const Material& material, const Object& object,
                                  const SurfaceReference& surface, const gl::View& view = mapView(),
                                  const std::vector<Light>& lights = testLights(6))
    {
        Offscreen offscreen = makeOffscreen(kSize);
        return referenceImage(material,
                              geometryBuffer(gl(), offscreen, object.mesh, object.model, view),
                              lights, view, surface);
    }

    template <class A, class B>
    static void expectSame(const std::vector<A>& found, const std::vector<B>& expected, double most)
    {
        const auto difference = compareImages(found, expected);
        EXPECT_TRUE(difference.comparable);
        EXPECT_LE(difference.maxRelative, most) << describe(difference);
    }
    template <class A, class B>
    static void expectOther(const std::vector<A>& found, const std::vector<B>& expected)
    {
        const auto difference = compareImages(found, expected);
        EXPECT_TRUE(difference.comparable);
        EXPECT_GT(difference.maxRelative, kNoticed) << describe(difference);
    }

    /// A texture of the host: float texels, kSize x kSize, one a pixel.
    uint32_t normalMap(const std::vector<Vec3f>& normals)
    {
        std::vector<float> texels;
        for (const Vec3f& n : normals)
            for (int c = 0; c < 3; ++c) texels.push_back(0.5f + 0.5f * n[c]);
        gl().GenTextures(1, &map_);
        gl().BindTexture(GL_TEXTURE_2D, map_);
        gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        const auto size = static_cast<GLsizei>(std::sqrt(static_cast<double>(normals.size())));
        gl().TexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, size, size, 0, GL_RGB, GL_FLOAT,
                        texels.data());
        gl().BindTexture(GL_TEXTURE_2D, 0);
        return map_;
    }

    std::shared_ptr<gl::GpuHooks> hooksOf(const std::string& vertex, const std::string& shadow)
    {
        gl::Hooks hooks;
        hooks.vertex = vertex;
        hooks.shadow = shadow;
        return renderer_->createHooks(hooks);
    }

private:
    GLuint map_ = 0;
};

/// A normal for each texel.
inline std::vector<Vec3f> bumps()
{
    std::vector<Vec3f> normals;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x)
            normals.emplace_back(0.5f * std::sin(0.4f * static_cast<float>(x)),
                                 0.4f * std::cos(0.3f * static_cast<float>(y)), 0.8f);
    return normals;
}

}  // namespace fbrdf::test
