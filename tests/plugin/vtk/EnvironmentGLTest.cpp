// The environment of a vtkRenderer lights materials as the runtime's does.
#include "VtkScene.h"

#include "support/gl/EnvironmentScenes.h"
#include "support/gl/Scenes.h"

#include <fbrdf/gl/Environment.h>

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkOpenGLRenderer.h>
#include <vtkPBRIrradianceTexture.h>
#include <vtkPBRLUTTexture.h>
#include <vtkPBRPrefilterTexture.h>
#include <vtkTexture.h>

#include <array>

namespace fbrdf::test {
namespace {

constexpr int kFaceSize = 32;
// The cube of VTK's picture is the mirror image of the runtime's, so that the cells by which it is
// convolved lie in other places: each is good to a percent.
constexpr double kAgainstRuntime = 1e-2, kMean = 3e-4;

/// The panorama as VTK has it: rows from the bottom, the middle column at +x instead of -z.
vtkSmartPointer<vtkTexture> vtkPicture(const Panorama& panorama)
{
    vtkNew<vtkImageData> image;
    image->SetDimensions(panorama.width, panorama.height, 1);
    image->AllocateScalars(VTK_FLOAT, 3);
    auto* texel = static_cast<float*>(image->GetScalarPointer());
    for (int y = panorama.height - 1; y >= 0; --y)
        for (int x = 0; x < panorama.width; ++x, texel += 3) {
            const Vec3f& value = panorama.texel((x + panorama.width / 4) % panorama.width, y);
            std::copy(&value.x, &value.x + 3, texel);
        }
    auto texture = vtkSmartPointer<vtkTexture>::New();
    texture->SetColorModeToDirectScalars();
    texture->MipmapOn();
    texture->InterpolateOn();
    texture->SetInputData(image);
    return texture;
}

class VtkEnvironment : public ::testing::Test {
protected:
    void SetUp() override
    {
        // VTK makes textures for its own PBR in the same frame.
        auto* const renderer = vtkOpenGLRenderer::SafeDownCast(&view_.renderer());
        renderer->GetEnvMapLookupTable()->SetLUTSize(8);
        renderer->GetEnvMapLookupTable()->SetLUTSamples(8);
        renderer->GetEnvMapIrradiance()->SetIrradianceSize(8);
        renderer->GetEnvMapIrradiance()->SetIrradianceStep(0.5f);
        renderer->GetEnvMapPrefiltered()->SetPrefilterLevels(1);
        renderer->GetEnvMapPrefiltered()->SetPrefilterMaxSamples(4);
        vtkFbrdfMaterial::SetEnvironmentFaceSize(renderer, kFaceSize);
        renderer->SetEnvironmentTexture(vtkPicture(panorama_));
        renderer->UseSphericalHarmonicsOff();
        view_.renderer().AddActor(actor_);
    }

    void switchOn(bool on) { view_.renderer().SetUseImageBasedLighting(on); }

    ImageDifference difference(const Material& material, const std::vector<Light>& lights,
                               const glm::mat3& rotation = glm::mat3(1.0f))
    {
        const auto vtk = vtkMaterial(material);
        vtk->ApplyTo(actor_);
        view_.setLights(lights);
        switchOn(true);
        const auto found = view_.frame();
        EXPECT_EQ(vtk->LastReport().whyNoEnvironment, "");
        return compareImages(found, view_.runtime(material, mesh_, lights,
                                                  {glm::mat4(1.0f), Transfer::linear, 1.0f,
                                                   &panorama_, kFaceSize, rotation}));
    }

    VtkView view_;
    const gl::MeshData mesh_ = sphereMesh(16);
    const Panorama panorama_ = testPanorama(32, 20.0f);
    vtkSmartPointer<vtkActor> actor_ = vtkActorOf(vtkMesh(mesh_));
};

TEST_F(VtkEnvironment, EqualsTheRuntimeWithAndWithoutLights)
{
    for (const auto& [form, lobes] : {std::pair{size_t{2}, testLobes(LobeAxes::tilted, 2)},
                                      std::pair{size_t{1}, testLobes(LobeAxes::bent, 3)}})
        for (const int count : {0, 5}) {
            const auto d =
                difference(withLobes(testMaterials()[form], lobes), vtkTestLights(count));
            EXPECT_TRUE(d.comparable && d.maxRelative < kAgainstRuntime && d.meanRelative < kMean)
                << form << ", " << count << " lights: " << describe(d);
        }
}

TEST_F(VtkEnvironment, TurnsWithTheRenderersAxesAndStaysWhereTheCameraMoves)
{
    // Up stays, +x goes to -z.
    view_.renderer().SetEnvironmentRight(0.0, 0.0, -1.0);
    const Material material = withLobes(testMaterials()[2], testLobes(LobeAxes::tilted, 2));
    const auto rotation = gl::environmentRotation(static_cast<float>(0.5 * kPi));
    const auto d = difference(material, {}, rotation);
    EXPECT_TRUE(d.comparable && d.maxRelative < kAgainstRuntime && d.meanRelative < kMean)
        << describe(d);
    view_.setView(perspectiveView());
    const auto turned = difference(material, {}, rotation);
    EXPECT_TRUE(turned.comparable && turned.meanRelative < kMean) << describe(turned);
}

TEST_F(VtkEnvironment, IsSwitchedOnAndOffAndReplacedAtOnce)
{
    const Material material = withLobes(testMaterials()[2], testLobes(LobeAxes::tilted, 2));
    const auto lights = vtkTestLights(3);
    const auto vtk = vtkMaterial(material);
    vtk->ApplyTo(actor_);
    view_.setLights(lights);
    const auto dark = view_.frame();
    switchOn(true);
    const auto lit = view_.frame();
    EXPECT_GT(compareImages(lit, dark).meanRelative, 0.01);
    switchOn(false);
    EXPECT_EQ(view_.frame(), dark);
    switchOn(true);
    EXPECT_EQ(view_.frame(), lit);
    view_.renderer().SetEnvironmentTexture(vtkPicture(whitePanorama()));
    EXPECT_GT(compareImages(view_.frame(), lit).meanRelative, 0.01);
}

TEST_F(VtkEnvironment, LobesThatAMaterialLacksAreFitted)
{
    const auto vtk = vtkMaterial(whiteMaterial());
    vtk->ApplyTo(actor_);
    view_.renderer().SetEnvironmentTexture(vtkPicture(whitePanorama()));
    switchOn(true);
    const auto image = view_.frame();
    // A white surface in white light is white everywhere.
    constexpr float kFitted = 0.02f;
    EXPECT_NEAR(image[4 * (kSize / 2 * kSize + kSize / 2)], 1.0f, kFitted);
    EXPECT_EQ(vtk->LastReport().whyNoEnvironment, "");
}

/// A cube of one colour a face: +x -x +y -y +z -z.
vtkSmartPointer<vtkTexture> vtkCube(const std::array<float, 6>& faces)
{
    auto texture = vtkSmartPointer<vtkTexture>::New();
    texture->CubeMapOn();
    texture->SetColorModeToDirectScalars();
    texture->MipmapOn();
    texture->InterpolateOn();
    for (int face = 0; face < 6; ++face) {
        vtkNew<vtkImageData> image;
        image->SetDimensions(8, 8, 1);
        image->AllocateScalars(VTK_FLOAT, 3);
        auto* const texels = static_cast<float*>(image->GetScalarPointer());
        std::fill(texels, texels + 3 * 64, faces[static_cast<size_t>(face)]);
        texture->SetInputDataObject(face, image);
    }
    return texture;
}

TEST_F(VtkEnvironment, MayBeACube)
{
    // Light from +y: the upper side of a white sphere is bright, the lower one is dark.
    const auto vtk = vtkMaterial(whiteMaterial());
    vtk->ApplyTo(actor_);
    view_.renderer().SetEnvironmentTexture(vtkCube({0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f}));
    switchOn(true);
    const auto image = view_.frame();
    EXPECT_EQ(vtk->LastReport().whyNoEnvironment, "");
    const auto at = [&image](int x, int y) {
        return image[static_cast<size_t>(4 * (y * kSize + x))];
    };
    EXPECT_GT(at(kSize / 2, kSize - 10), 0.35f);
    EXPECT_LT(at(kSize / 2, 10), 0.1f);
    EXPECT_NEAR(at(kSize / 2 - 16, kSize / 2), at(kSize / 2 + 16, kSize / 2), 0.02f);
}

}  // namespace
}  // namespace fbrdf::test
