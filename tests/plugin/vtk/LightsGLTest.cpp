// A white Lambertian material is lit as VTK lights a white property of diffuse coefficient 1, under
// lights of every kind.
#include "VtkScene.h"

#include "support/gl/Scenes.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkLightCollection.h>
#include <vtkLightKit.h>
#include <vtkMapper.h>
#include <vtkOpenGLRenderer.h>
#include <vtkTransform.h>

#include <cmath>
#include <functional>
#include <limits>

namespace fbrdf::test {
namespace {

// Both compute with floats; cones have an edge of 1e-4 in cosine here and none in VTK, so a few
// pixels on it are left out.
constexpr double kAgainstVtk = 1e-4;
constexpr double kConeEdge = 0.01;  // share of the pixels

struct Kind {
    const char* name;
    std::function<void(vtkLight&)> set;
};

void aim(vtkLight& light)
{
    light.SetPosition(1.5, 1.0, 2.5);
    light.SetFocalPoint(0.2, -0.1, 0.3);
    light.SetDiffuseColor(0.9, 0.6, 0.3);
    light.SetIntensity(1.5);
}

void makeSpot(vtkLight& light, double cone, double exponent)
{
    aim(light);
    light.PositionalOn();
    light.SetConeAngle(cone);
    light.SetExponent(exponent);
    light.SetAttenuationValues(0.5, 0.1, 0.05);
}

std::vector<Kind> kinds()
{
    return {{"scene, directional", aim},
            {"headlight", [](vtkLight& l) { l.SetLightTypeToHeadlight(); }},
            {"camera",
             [](vtkLight& l) {
                 l.SetLightTypeToCameraLight();
                 l.SetPosition(1.0, 0.5, 1.0);
                 l.SetFocalPoint(0.0, 0.0, 0.0);
             }},
            {"camera, positional",
             [](vtkLight& l) {
                 l.SetLightTypeToCameraLight();
                 l.SetPosition(0.8, 0.5, 0.3);
                 l.SetFocalPoint(0.0, 0.0, 0.0);
                 l.PositionalOn();
                 l.SetConeAngle(90.0);
                 l.SetAttenuationValues(0.0, 0.3, 0.2);
             }},
            {"point, constant",
             [](vtkLight& l) {
                 aim(l);
                 l.PositionalOn();
                 l.SetConeAngle(120.0);
             }},
            {"point, inverse square",
             [](vtkLight& l) {
                 aim(l);
                 l.PositionalOn();
                 l.SetConeAngle(90.0);
                 l.SetAttenuationValues(0.0, 0.0, 0.5);
             }},
            {"spot", [](vtkLight& l) { makeSpot(l, 20.0, 1.0); }},
            {"spot, pointed", [](vtkLight& l) { makeSpot(l, 60.0, 8.0); }},
            {"spot, flat", [](vtkLight& l) { makeSpot(l, 15.0, 0.0); }}};
}

class VtkLights : public ::testing::Test {
protected:
    void SetUp() override
    {
        actor_ = vtkActorOf(vtkMesh(sphereMesh(24)));
        view_.renderer().AddActor(actor_);
    }

    vtkLight& add(const Kind& kind)
    {
        vtkNew<vtkLight> light;
        light->SetLightTypeToSceneLight();
        kind.set(*light);
        view_.renderer().AddLight(light);
        return *light;
    }

    /// The share of the pixels that differ by more than rounding.
    double shareApart()
    {
        const auto vtk = view_.frame();
        material_->ApplyTo(actor_);
        const auto found = view_.frame();
        material_->RemoveFrom(actor_);
        double apart = 0.0, lit = 0.0;
        for (size_t i = 0; i < vtk.size(); ++i) {
            const double a = static_cast<double>(found[i]), b = static_cast<double>(vtk[i]);
            apart += std::abs(a - b) > kAgainstVtk * std::max(1.0, b) || !std::isfinite(a) ? 1 : 0;
            lit += i % 4 < 3 && b > 0.01 ? 1 : 0;
        }
        EXPECT_GT(lit, 100.0);
        return apart / static_cast<double>(vtk.size());
    }

    VtkView view_;
    vtkSmartPointer<vtkActor> actor_;
    vtkSmartPointer<vtkFbrdfMaterial> material_ = vtkMaterial(whiteMaterial());
};

TEST_F(VtkLights, EachKindShinesAsInVtk)
{
    for (const Kind& kind : kinds()) {
        view_.renderer().RemoveAllLights();
        const bool isSpot = add(kind).GetConeAngle() < 90.0 && kind.name[0] == 's';
        EXPECT_LE(shareApart(), isSpot ? kConeEdge : 0.0) << kind.name;
    }
}

TEST_F(VtkLights, AllKindsAtOnceShineAsInVtk)
{
    for (int i = 0; i < 2; ++i)
        for (const Kind& kind : kinds()) add(kind).SetIntensity(0.1 + 0.1 * i);
    EXPECT_LE(shareApart(), 4.0 * kConeEdge);
    EXPECT_EQ(material_->LastReport().lightsUsed, 18);
}

TEST_F(VtkLights, AKitShinesAsInVtk)
{
    vtkNew<vtkLightKit> kit;
    kit->AddLightsToRenderer(&view_.renderer());
    EXPECT_EQ(shareApart(), 0.0);
}

TEST_F(VtkLights, FollowTheirCamera)
{
    add(kinds()[2]);
    add(kinds()[0]);
    EXPECT_EQ(shareApart(), 0.0);
    view_.renderer().GetActiveCamera()->Azimuth(40.0);
    EXPECT_EQ(shareApart(), 0.0);
}

TEST_F(VtkLights, AreMovedOnceMoreByTheUsersTransform)
{
    add(kinds()[2]);
    vtkNew<vtkTransform> turn;
    turn->RotateY(50.0);
    vtkOpenGLRenderer::SafeDownCast(&view_.renderer())->SetUserLightTransform(turn);
    EXPECT_EQ(shareApart(), 0.0);
}

TEST_F(VtkLights, ComeAndGoWithoutAnotherProgram)
{
    material_->ApplyTo(actor_);
    vtkShaderProgram* program = nullptr;
    vtkNew<vtkCallbackCommand> look;
    look->SetClientData(&program);
    look->SetCallback([](vtkObject*, unsigned long, void* data, void* called) {
        *static_cast<vtkShaderProgram**>(data) = static_cast<vtkShaderProgram*>(called);
    });
    actor_->GetMapper()->AddObserver(vtkCommand::UpdateShaderEvent, look);
    add(kinds()[0]);
    view_.frame();
    vtkShaderProgram* const first = program;
    ASSERT_NE(first, nullptr);
    for (int i = 0; i < 20; ++i) add(kinds()[static_cast<size_t>(i) % kinds().size()]);
    view_.frame();
    EXPECT_EQ(program, first);
    EXPECT_EQ(material_->LastReport().lightsUsed, 21);
    auto* const last = vtkLight::SafeDownCast(view_.renderer().GetLights()->GetItemAsObject(3));
    last->SwitchOff();
    view_.frame();
    EXPECT_EQ(program, first);
    EXPECT_EQ(material_->LastReport().lightsUsed, 20);
}

TEST_F(VtkLights, NoLightIsBlackAndABrokenOneIsLeftOut)
{
    VtkLog log;
    material_->ApplyTo(actor_);
    for (const float value : view_.frame()) EXPECT_TRUE(value == 0.0f || value == 1.0f);
    add(kinds()[0]);
    add(kinds()[0]).SetPosition(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
    view_.frame();
    view_.frame();
    EXPECT_EQ(material_->LastReport().lightsUsed, 1);
    EXPECT_EQ(material_->LastReport().lightsDropped, 1);
    EXPECT_EQ(log.count("lights are left out: found 2, 1 of which"), 1) << log.text();
}

}  // namespace
}  // namespace fbrdf::test
