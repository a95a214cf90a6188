// What cannot be read or drawn: one line in VTK's log with file and reason, and a diffuse actor of
// the material's albedo.
#include "VtkScene.h"

#include "MapTextures.h"
#include "support/FileBytes.h"
#include "support/gl/Scenes.h"
#include "support/NewerFile.h"
#include "support/TemporaryDir.h"

#include <fbrdf/io/MaterialFile.h>

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkProperty.h>
#include <vtkTextureUnitManager.h>

namespace fbrdf::test {
namespace {

constexpr double kSame = 1e-5;

class VtkFaults : public ::testing::Test {
protected:
    void SetUp() override
    {
        view_.renderer().AddActor(actor_);
        view_.setLights({{Light::Type::directional, {1.0f, 0.5f, 2.0f}, Vec3f(2.5f)}});
        material_->SetName("gold");
        material_->ApplyTo(actor_);
    }

    /// What VTK draws of a diffuse actor.
    std::vector<float> diffuse(const Vec3f& albedo)
    {
        const auto plain = vtkActorOf(vtkMesh(sphereMesh(24)));
        const Vec3d colour(albedo);
        plain->GetProperty()->SetColor(colour.x, colour.y, colour.z);
        actor_->VisibilityOff();
        view_.renderer().AddActor(plain);
        auto image = view_.frame();
        view_.renderer().RemoveActor(plain);
        actor_->VisibilityOn();
        return image;
    }

    /// The fallback is drawn, and the log says once that and why.
    void expectFallback(const std::string& reason, const Vec3f& albedo)
    {
        const auto found = view_.frame();
        view_.frame();
        EXPECT_EQ(material_->LastReport().technique, "diffuse fallback");
        EXPECT_NE(material_->LastReport().reason.find(reason), std::string::npos)
            << material_->LastReport().reason;
        EXPECT_EQ(log_.count("diffuse fallback is drawn: " + reason), 1) << log_.text();
        const auto d = compareImages(found, diffuse(albedo));
        EXPECT_TRUE(d.comparable && d.maxRelative < kSame) << describe(d);
        EXPECT_GT(found[4 * (kSize / 2 * kSize + kSize / 2)], 0.02f);
    }

    TemporaryDir folder_;
    VtkLog log_;
    VtkView view_;
    vtkSmartPointer<vtkActor> actor_ = vtkActorOf(vtkMesh(sphereMesh(24)));
    vtkNew<vtkFbrdfMaterial> material_;
};

TEST_F(VtkFaults, NoMaterialIsAGreyActor)
{
    expectFallback("no material", Vec3f(0.5f));
}

TEST_F(VtkFaults, FilesThatCannotBeReadAreNamedWithTheReason)
{
    const Material material = testMaterials()[0];
    writeMaterial(material, folder_.file("good.fbrdf"));
    const std::string good = fileBytes(folder_.file("good.fbrdf"));
    writeNewerVersion(folder_.file("good.fbrdf"), folder_.file("newer.fbrdf"));
    putFile(folder_.file("short.fbrdf"), good.substr(0, good.size() / 2));
    putFile(folder_.file("words.fbrdf"), "this is no material");
    for (const char* name : {"missing.fbrdf", "newer.fbrdf", "short.fbrdf", "words.fbrdf", ""}) {
        EXPECT_FALSE(material_->SetMaterialFile(folder_.file(name))) << name;
        EXPECT_EQ(material_->GetMaterialFile(), folder_.file(name));
        EXPECT_NE(log_.text().find(folder_.file(name) + ": "), std::string::npos) << log_.text();
    }
    EXPECT_EQ(log_.count("missing.fbrdf: found no such file, expected a material"), 1)
        << log_.text();
    EXPECT_EQ(log_.count("ERROR: "), 5) << log_.text();
    view_.frame();
    EXPECT_EQ(
        log_.count("'gold', " + folder_.file("") + ": diffuse fallback is drawn: no material"), 1)
        << log_.text();
    EXPECT_TRUE(material_->SetMaterialFile(folder_.file("good.fbrdf")));
    view_.frame();
    EXPECT_EQ(material_->LastReport().technique, "single pass");
}

TEST_F(VtkFaults, ReloadingABrokenFileKeepsTheLastGoodMaterial)
{
    const std::string file = folder_.file("changing.fbrdf");
    writeMaterial(testMaterials()[0], file);
    ASSERT_TRUE(material_->SetMaterialFile(file));
    const auto before = view_.frame();
    putFile(file, "broken");
    EXPECT_FALSE(material_->ReloadMaterial());
    EXPECT_EQ(view_.frame(), before);
    writeMaterial(testMaterials()[2], file);
    EXPECT_TRUE(material_->ReloadMaterial());
    EXPECT_NE(view_.frame(), before);
}

TEST_F(VtkFaults, AMaterialThatIsNotValidIsRefused)
{
    Material broken = testMaterials()[0];
    broken.scales.clear();
    EXPECT_FALSE(material_->SetMaterial(broken));
    EXPECT_EQ(log_.count("found 0 scales, expected one for each of 1 terms"), 1) << log_.text();
    expectFallback("no material", Vec3f(0.5f));
}

TEST_F(VtkFaults, TooFewTextureUnits)
{
    const Material material = testMaterials()[0];
    ASSERT_TRUE(material_->SetMaterial(material));
    actor_->VisibilityOff();
    view_.frame();
    actor_->VisibilityOn();
    auto* const window = vtkOpenGLRenderWindow::SafeDownCast(&view_.window());
    vtkTextureUnitManager* const units = window->GetState()->GetTextureUnitManager();
    const int last = units->GetNumberOfTextureUnits() - 1;
    for (int unit = 2; unit <= last; ++unit) units->Allocate(unit);
    // A pass with a colour texture of its own would want units, too.
    view_.window().Render();
    for (int unit = 2; unit <= last; ++unit) units->Free(unit);
    EXPECT_EQ(log_.count("'gold': diffuse fallback is drawn: texture units: found 2, expected at "
                         "least 3"),
              1)
        << log_.text();
    expectFallback("texture units", diffuseAlbedo(material));
}

TEST_F(VtkFaults, ShadersThatDoNotCompileAreKnownBefore)
{
    view_.frame();
    EXPECT_EQ(vtk::whyNotCompiled("out vec4 colour;\nvoid main() { colour = vec4(1.0); }\n"), "");
    const std::string reason = vtk::whyNotCompiled("void main() { undeclared = 1.0; }\n");
    EXPECT_EQ(reason.rfind("found no GLSL (", 0), 0u) << reason;
    EXPECT_NE(reason.find("expected 1.50"), std::string::npos) << reason;
    EXPECT_EQ(reason.find('\n'), std::string::npos);
}

TEST_F(VtkFaults, TheFallbackIsLitByAllKindsOfProperties)
{
    for (const int interpolation : {VTK_FLAT, VTK_GOURAUD, VTK_PHONG, VTK_PBR}) {
        actor_->GetProperty()->SetInterpolation(interpolation);
        actor_->GetProperty()->EdgeVisibilityOn();
        const auto image = view_.frame();
        EXPECT_GT(*std::max_element(image.begin(), image.end()), 0.1f) << interpolation;
    }
    actor_->GetProperty()->EdgeVisibilityOff();
    actor_->GetProperty()->LightingOff();
    const auto image = view_.frame();
    EXPECT_FLOAT_EQ(image[4 * (kSize / 2 * kSize + kSize / 2)], 0.5f);
    EXPECT_EQ(log_.count("ERROR"), 0) << log_.text();
}

}  // namespace
}  // namespace fbrdf::test
