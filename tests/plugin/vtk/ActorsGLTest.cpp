// What actors, properties and meshes may have or change while they have a material.
#include "VtkScene.h"

#include "support/gl/CompareImages.h"
#include "support/gl/Scenes.h"

#include <vtkAssembly.h>
#include <vtkCompositePolyDataMapper2.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkTexture.h>

#include <glm/gtc/type_ptr.hpp>

namespace fbrdf::test {
namespace {

constexpr double kSame = 1e-5;  // the same program on the same numbers
constexpr double kAgainstRuntime = 1e-4;

/// The sphere's own (u, v): s runs along its tangents.
void addTextureCoordinates(vtkPolyData& mesh, int rings)
{
    vtkNew<vtkFloatArray> coordinates;
    coordinates->SetName("TextureCoordinates");
    coordinates->SetNumberOfComponents(2);
    for (int i = 0; i <= rings; ++i)
        for (int j = 0; j <= 2 * rings; ++j)
            coordinates->InsertNextTuple2(0.5 * j / rings, 1.0 - static_cast<double>(i) / rings);
    mesh.GetPointData()->SetTCoords(coordinates);
}

void addScalars(vtkPolyData& mesh)
{
    vtkNew<vtkFloatArray> scalars;
    scalars->SetName("Height");
    for (vtkIdType i = 0; i < mesh.GetNumberOfPoints(); ++i)
        scalars->InsertNextValue(static_cast<float>(0.5 + 0.5 * mesh.GetPoint(i)[1]));
    mesh.GetPointData()->SetScalars(scalars);
}

vtkSmartPointer<vtkTexture> stripes()
{
    vtkNew<vtkImageData> image;
    image->SetDimensions(4, 4, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* const bytes = static_cast<unsigned char*>(image->GetScalarPointer());
    for (int i = 0; i < 48; ++i) bytes[i] = i % 2 ? 255 : 20;
    auto texture = vtkSmartPointer<vtkTexture>::New();
    texture->SetInputData(image);
    return texture;
}

class VtkActors : public ::testing::Test {
protected:
    void SetUp() override
    {
        actor_ = vtkActorOf(vtkMesh(mesh_));
        material_->ApplyTo(actor_);
        view_.renderer().AddActor(actor_);
        view_.setLights(lights_);
        plain_ = view_.frame();
    }

    void expectUnchanged(const char* what, double tolerance = kSame)
    {
        const auto d = compareImages(view_.frame(), plain_);
        EXPECT_TRUE(d.comparable && d.maxRelative < tolerance) << what << ": " << describe(d);
        EXPECT_EQ(material_->LastReport().technique, "single pass") << what;
    }

    double changeOf(const std::vector<float>& image)
    {
        return compareImages(image, plain_).meanRelative;
    }

    vtkPolyData& data() { return *vtkPolyData::SafeDownCast(actor_->GetMapper()->GetInput()); }

    VtkView view_;
    const gl::MeshData mesh_ = sphereMesh(24);
    const Material anisotropic_ = testMaterials()[1];
    const std::vector<Light> lights_ = vtkTestLights(5);
    vtkSmartPointer<vtkFbrdfMaterial> material_ = vtkMaterial(anisotropic_);
    vtkSmartPointer<vtkActor> actor_;
    std::vector<float> plain_;
};

TEST_F(VtkActors, ColoursScalarsAndTexturesDoNotMatter)
{
    vtkProperty* const property = actor_->GetProperty();
    property->SetColor(0.2, 0.9, 0.1);
    property->SetSpecular(0.8);
    expectUnchanged("colours");
    addScalars(data());
    expectUnchanged("scalars on");
    actor_->GetMapper()->InterpolateScalarsBeforeMappingOn();
    expectUnchanged("scalars as a texture");
    actor_->GetMapper()->ScalarVisibilityOff();
    expectUnchanged("scalars off");
    addTextureCoordinates(data(), 24);
    expectUnchanged("texture coordinates");
    actor_->SetTexture(stripes());
    property->SetTexture("ours", stripes());
    expectUnchanged("textures");
    property->SetInterpolationToPBR();
    expectUnchanged("PBR");
}

TEST_F(VtkActors, TangentsAreThoseOfTheMeshOrAlongS)
{
    // Derived tangents are constant within a triangle, of which the sphere has 2304.
    constexpr double kDerived = 0.05;
    gl::MeshData bare = mesh_;
    bare.tangents.clear();
    actor_->SetMapper(vtkActorOf(vtkMesh(bare))->GetMapper());
    EXPECT_GT(changeOf(view_.frame()), kDerived);
    addTextureCoordinates(data(), 24);
    EXPECT_LT(changeOf(view_.frame()), kDerived);
    // Tangents that are there come first, unless those along s are asked for.
    vtkNew<vtkFloatArray> across;
    across->SetName("Tangents");
    across->SetNumberOfComponents(3);
    for (const auto& t : mesh_.tangents) across->InsertNextTuple3(t.z, 1.0f, -t.x);
    data().GetPointData()->SetTangents(across);
    EXPECT_GT(changeOf(view_.frame()), kDerived);
    material_->SetDerivedTangents(true);
    EXPECT_LT(changeOf(view_.frame()), kDerived);
}

TEST_F(VtkActors, MayBeMovedTurnedAndScaled)
{
    // Corners round in other ways where matrices are multiplied before.
    constexpr double kTurned = 2e-3, kMean = 1e-5;
    actor_->SetPosition(0.2, -0.3, 0.4);
    actor_->RotateY(70.0);
    actor_->SetScale(0.6, 0.9, 0.7);
    const glm::mat4 place(glm::transpose(glm::make_mat4(actor_->GetMatrix()->GetData())));
    const auto d =
        compareCovered(view_.frame(), view_.runtime(anisotropic_, mesh_, lights_, {place}));
    EXPECT_TRUE(d.comparable && d.maxRelative < kTurned && d.meanRelative < kMean) << describe(d);
}

TEST_F(VtkActors, ClippingPlanesCutThem)
{
    vtkNew<vtkPlane> plane;
    plane->SetNormal(1.0, 0.0, 0.0);
    actor_->GetMapper()->AddClippingPlane(plane);
    const auto cut = view_.frame();
    for (size_t i = 0; i < cut.size(); i += 4) {
        const size_t x = i / 4 % kSize;
        if (x < kSize / 2 - 4) {
            EXPECT_FLOAT_EQ(cut[i], 0.0f);
        }
        if (x > kSize / 2 + 4) {
            EXPECT_FLOAT_EQ(cut[i], plain_[i]);
        }
    }
}

TEST_F(VtkActors, MayHaveAnotherPropertyShadersOrMapper)
{
    vtkNew<vtkProperty> other;
    actor_->SetProperty(other);
    expectUnchanged("another property");
    other->RemoveAllTextures();
    expectUnchanged("a property without textures");
    vtkNew<vtkShaderProperty> unused;
    actor_->GetShaderProperty()->ClearAllShaderReplacements();
    expectUnchanged("no replacements");
    actor_->GetShaderProperty()->AddFragmentShaderReplacement(
        "//VTK::Light::Impl", false, "  gl_FragData[0].rgb *= 2.0;\n", true);
    const auto twice = view_.frame();
    EXPECT_NEAR(static_cast<double>(twice[4 * (32 * 64 + 32)]),
                2.0 * static_cast<double>(plain_[4 * (32 * 64 + 32)]), 1e-4);
    actor_->GetShaderProperty()->ClearAllShaderReplacements();
    actor_->SetMapper(vtkActorOf(vtkMesh(mesh_))->GetMapper());
    expectUnchanged("another mapper");
}

TEST_F(VtkActors, PropertiesAreSharedWithActorsWithoutOrWithAnotherMaterial)
{
    const auto beside = vtkActorOf(vtkMesh(mesh_));
    addTextureCoordinates(*vtkPolyData::SafeDownCast(beside->GetMapper()->GetInput()), 24);
    beside->SetProperty(actor_->GetProperty());
    beside->SetPosition(0.0, 0.0, -2.5);
    view_.renderer().AddActor(beside);
    view_.frame();
    const auto other = vtkMaterial(testMaterials()[0]);
    other->ApplyTo(beside);
    view_.frame();
    EXPECT_EQ(other->LastReport().technique, "single pass");
    beside->VisibilityOff();
    expectUnchanged("a shared property");
}

TEST_F(VtkActors, AreDrawnWithinAssembliesAndByCompositeMappers)
{
    view_.renderer().RemoveAllViewProps();
    vtkNew<vtkAssembly> assembly;
    assembly->AddPart(actor_);
    view_.renderer().AddActor(assembly);
    expectUnchanged("an assembly");
    view_.renderer().RemoveAllViewProps();
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, vtkMesh(mesh_));
    vtkNew<vtkCompositePolyDataMapper2> mapper;
    mapper->SetInputDataObject(blocks);
    vtkNew<vtkActor> whole;
    whole->SetMapper(mapper);
    material_->ApplyTo(whole);
    view_.renderer().AddActor(whole);
    expectUnchanged("a composite mapper");
}

TEST_F(VtkActors, MaterialsAreReplacedRemovedAndKeptAlive)
{
    const Material second = testMaterials()[2];
    {
        const auto other = vtkMaterial(second);
        other->ApplyTo(actor_);
        EXPECT_EQ(vtkFbrdfMaterial::Of(actor_), other.Get());
    }
    const auto d = compareImages(view_.frame(), view_.runtime(second, mesh_, lights_));
    EXPECT_TRUE(d.comparable && d.maxRelative < kAgainstRuntime) << describe(d);
    vtkFbrdfMaterial::Of(actor_)->RemoveFrom(actor_);
    EXPECT_EQ(vtkFbrdfMaterial::Of(actor_), nullptr);
    EXPECT_GT(changeOf(view_.frame()), 0.01);
    material_->ApplyTo(actor_);
    expectUnchanged("the first material again");
    material_->SetMaterial(second);
    const auto again = compareImages(view_.frame(), view_.runtime(second, mesh_, lights_));
    EXPECT_TRUE(again.comparable && again.maxRelative < kAgainstRuntime) << describe(again);
}

TEST_F(VtkActors, ExposureTransferAndPreciseFiltering)
{
    material_->SetExposure(3.0f);
    material_->SetTransfer(Transfer::toneMap);
    const auto expected =
        view_.runtime(anisotropic_, mesh_, lights_, {glm::mat4(1.0f), Transfer::toneMap, 3.0f});
    auto d = compareImages(view_.frame(), expected);
    EXPECT_TRUE(d.comparable && d.maxRelative < kAgainstRuntime) << describe(d);
    material_->SetPreciseFiltering(true);
    d = compareImages(view_.frame(), expected);
    EXPECT_TRUE(d.comparable && d.maxRelative < kAgainstRuntime) << describe(d);
    material_->SetTransfer(Transfer::srgb);
    d = compareImages(view_.frame(), view_.runtime(anisotropic_, mesh_, lights_,
                                                   {glm::mat4(1.0f), Transfer::srgb, 3.0f}));
    EXPECT_TRUE(d.comparable && d.maxRelative < kAgainstRuntime) << describe(d);
}

}  // namespace
}  // namespace fbrdf::test
