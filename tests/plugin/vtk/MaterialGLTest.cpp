// What VTK draws of an actor with a material is what the plain runtime draws.
#include "VtkScene.h"

#include "support/gl/CompareImages.h"
#include "support/gl/Scenes.h"

#include <vtkCamera.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <glm/gtc/matrix_transform.hpp>

namespace fbrdf::test {
namespace {

// The same arithmetic on floats, but VTK multiplies its matrices in double on the CPU.
constexpr double kAgainstRuntime = 1e-4;

class VtkDraw : public ::testing::Test {
protected:
    vtkSmartPointer<vtkActor> show(const gl::MeshData& mesh, vtkFbrdfMaterial* material)
    {
        auto actor = vtkActorOf(vtkMesh(mesh));
        material->ApplyTo(actor);
        view_.renderer().RemoveAllViewProps();
        view_.renderer().AddActor(actor);
        return actor;
    }

    ImageDifference difference(const Material& material, const gl::MeshData& mesh,
                               const std::vector<Light>& lights)
    {
        const auto vtk = vtkMaterial(material);
        const auto actor = show(mesh, vtk);
        view_.setLights(lights);
        const auto found = view_.frame();
        EXPECT_EQ(vtk->LastReport().technique, "single pass") << vtk->LastReport().reason;
        EXPECT_EQ(vtk->LastReport().lightsUsed, static_cast<int>(lights.size()));
        return compareCovered(found, view_.runtime(material, mesh, lights));
    }

    VtkView view_;
};

TEST_F(VtkDraw, EveryFormEqualsTheRuntime)
{
    for (const Material& material : testMaterials())
        for (const int count : {1, 9}) {
            const auto d = difference(material, sphereMesh(24), vtkTestLights(count));
            EXPECT_TRUE(d.comparable && d.maxRelative < kAgainstRuntime)
                << material.name << ", " << count << " lights: " << describe(d);
        }
}

TEST_F(VtkDraw, AKnotWithEdgesEverywhereEqualsTheRuntime)
{
    // Its triangles are smaller than pixels where they are seen edge-on, so that the rounding of
    // their corners moves what is interpolated.
    constexpr double kEdgeOn = 2e-3, kMean = 1e-6;
    view_.setView(perspectiveView());
    const auto d = difference(testMaterials()[1], knotMesh(96, 16), vtkTestLights(9));
    EXPECT_TRUE(d.comparable && d.maxRelative < kEdgeOn && d.meanRelative < kMean) << describe(d);
}

TEST_F(VtkDraw, ManyLightsEqualTheRuntime)
{
    for (const int count : {64, 200, 700}) {
        const auto d = difference(testMaterials()[2], sphereMesh(24), vtkTestLights(count));
        EXPECT_TRUE(d.comparable && d.maxRelative < kAgainstRuntime)
            << count << " lights: " << describe(d);
    }
}

TEST_F(VtkDraw, AParallelProjectionEqualsTheRuntime)
{
    view_.view.projection = orthographicView().projection;
    vtkCamera* const camera = view_.renderer().GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(1.2);
    const auto d = difference(testMaterials()[1], sphereMesh(24), vtkTestLights(5));
    EXPECT_TRUE(d.comparable && d.maxRelative < kAgainstRuntime) << describe(d);
}

TEST_F(VtkDraw, ALostLightIsNoticed)
{
    const Material material = testMaterials()[0];
    auto lights = vtkTestLights(9);
    const auto actor = show(sphereMesh(24), vtkMaterial(material));
    view_.setLights(lights);
    const auto found = view_.frame();
    lights.pop_back();
    EXPECT_GT(compareImages(found, view_.runtime(material, sphereMesh(24), lights)).maxRelative,
              10.0 * kAgainstRuntime);
}

}  // namespace
}  // namespace fbrdf::test
