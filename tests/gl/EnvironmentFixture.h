// EnvironmentFixture.h - a sphere under an environment, for tests that compare pictures of it.
#pragma once
#include "support/gl/EnvironmentReference.h"
#include "support/gl/GlTest.h"

namespace fbrdf::test {

class EnvironmentFixture : public RendererTest {
protected:
    /// size: pixels on a side of pictures; options: of the environment.
    EnvironmentFixture(int size, const gl::EnvironmentOptions& options)
        : size_(size), options_(options)
    {
    }

    void SetUp() override
    {
        RendererTest::SetUp();
        if (!isReady()) return;
        mesh_ = sphereMesh(16);
        gpuMesh_ = renderer_->createMesh(mesh_);
        environment_ = made(testPanorama(64));
        Offscreen floats = makeOffscreen(size_);
        geometry_ = geometryBuffer(gl(), floats, mesh_, glm::mat4(1.0f), perspectiveView());
    }
    void TearDown() override
    {
        environment_.reset();
        gpuMesh_.reset();
        RendererTest::TearDown();
    }

    std::shared_ptr<gl::GpuEnvironment> made(const Panorama& panorama)
    {
        return renderer_->createEnvironment(panorama, options_);
    }

    /// Turned, and of a colour: neither may be forgotten.
    gl::EnvironmentLight light() const
    {
        gl::EnvironmentLight light;
        light.map = environment_.get();
        light.rotation = gl::environmentRotation(0.7f);
        light.intensity = {0.5f, 1.0f, 2.0f};
        return light;
    }

    Drawn drawn(const Material& material, const std::vector<Light>& lights,
                const gl::DrawOptions& options)
    {
        const auto gpu = exactMaterial(*renderer_, material);
        return drawItems(*renderer_, size_, perspectiveView(), {{gpu.get(), gpuMesh_.get()}},
                         lights, options);
    }

    int size_;
    gl::EnvironmentOptions options_;
    gl::MeshData mesh_;
    std::shared_ptr<gl::GpuMesh> gpuMesh_;
    std::shared_ptr<gl::GpuEnvironment> environment_;
    GeometryBuffer geometry_;
};

}  // namespace fbrdf::test
