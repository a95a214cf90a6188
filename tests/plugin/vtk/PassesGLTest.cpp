// The passes, pickers and renderers of VTK, in which a white Lambertian material looks as a white
// property does.
#include "VtkScene.h"

#include "support/gl/Scenes.h"

#include <vtkCamera.h>
#include <vtkGlyph3DMapper.h>
#include <vtkHardwareSelector.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkMapper.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkRenderStepsPass.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>
#include <vtkSSAAPass.h>

#include <array>
#include <cstdlib>

namespace fbrdf::test {
namespace {

constexpr int kRounding = 1;  // levels of 8 bits: both round what differs by 1e-6
// At silhouettes VTK lights faces whose interpolated normals face away; a material is seen from its
// upper side alone. Lines and points have such normals everywhere.
constexpr double kSilhouettes = 0.015, kLinesAndPoints = 0.3;

using Bytes = std::vector<unsigned char>;

/// The share of the numbers that are further apart than rounding.
double shareApart(const Bytes& a, const Bytes& b)
{
    if (a.size() != b.size() || a.empty()) return 1.0;
    double apart = 0.0;
    for (size_t i = 0; i < a.size(); ++i) apart += std::abs(a[i] - b[i]) > kRounding ? 1.0 : 0.0;
    return apart / static_cast<double>(a.size());
}

int brightest(const Bytes& bytes)
{
    return bytes.empty() ? 0 : *std::max_element(bytes.begin(), bytes.end());
}

class VtkPasses : public ::testing::Test {
protected:
    void SetUp() override
    {
        for (const auto& actor : actors_) view_.renderer().AddActor(actor);
        actors_[1]->SetPosition(0.5, 0.2, -1.0);
        view_.renderer().AddLight(light_);
    }

    /// Pictures with the material and by VTK alone.
    std::pair<Bytes, Bytes> both()
    {
        view_.bytes();  // depth peeling adapts to the frame before
        const Bytes vtk = view_.bytes();
        for (const auto& actor : actors_) material_->ApplyTo(actor);
        view_.bytes();
        Bytes found = view_.bytes();
        EXPECT_EQ(material_->LastReport().technique, "single pass");
        for (const auto& actor : actors_) material_->RemoveFrom(actor);
        return {found, vtk};
    }

    void expectBothAlike(const char* what, double share = kSilhouettes)
    {
        const auto [found, vtk] = both();
        EXPECT_LE(shareApart(found, vtk), share) << what;
        EXPECT_GT(brightest(vtk), 60) << what;
    }

    VtkView view_;
    vtkSmartPointer<vtkLight> light_ =
        vtkLightOf({Light::Type::directional, {1.0f, 0.5f, 2.0f}, Vec3f(2.5f)});
    std::vector<vtkSmartPointer<vtkActor>> actors_{vtkActorOf(vtkMesh(sphereMesh(12))),
                                                   vtkActorOf(vtkMesh(knotMesh(48, 8)))};
    vtkSmartPointer<vtkFbrdfMaterial> material_ = vtkMaterial(whiteMaterial());
};

TEST_F(VtkPasses, OpaqueActors)
{
    expectBothAlike("opaque");
}

TEST_F(VtkPasses, TranslucentActorsWithAndWithoutDepthPeeling)
{
    actors_[0]->GetProperty()->SetOpacity(0.5);
    expectBothAlike("blended");
    view_.renderer().UseDepthPeelingOn();
    view_.renderer().SetMaximumNumberOfPeels(6);
    view_.renderer().SetOcclusionRatio(0.0);
    expectBothAlike("peeled");
    EXPECT_TRUE(view_.renderer().GetLastRenderingUsedDepthPeeling());
    actors_[1]->GetProperty()->SetOpacity(0.4);
    expectBothAlike("both peeled");
    view_.renderer().UseDepthPeelingOff();
    expectBothAlike("both blended");
}

TEST_F(VtkPasses, SupersamplingAndFastAntialiasing)
{
    view_.renderer().UseFXAAOn();
    expectBothAlike("FXAA");
    view_.renderer().UseFXAAOff();
    vtkNew<vtkRenderStepsPass> steps;
    vtkNew<vtkSSAAPass> fine;
    fine->SetDelegatePass(steps);
    view_.renderer().SetPass(fine);
    expectBothAlike("SSAA");
    fine->ReleaseGraphicsResources(&view_.window());
    view_.renderer().SetPass(nullptr);
    view_.window().SetMultiSamples(4);
    expectBothAlike("multisampling");
}

TEST_F(VtkPasses, AmbientOcclusion)
{
    view_.renderer().UseSSAOOn();
    view_.renderer().SetSSAORadius(0.3);
    view_.renderer().SetSSAOKernelSize(16);
    const auto [found, vtk] = both();
    // What is occluded depends on noise that VTK makes anew.
    EXPECT_GT(brightest(found), 60);
    EXPECT_EQ(found.size(), vtk.size());
}

TEST_F(VtkPasses, Glyphs)
{
    vtkNew<vtkPolyData> places;
    vtkNew<vtkPoints> points;
    for (const double x : {-0.6, 0.0, 0.6}) points->InsertNextPoint(x, 0.3 * x, 0.0);
    places->SetPoints(points);
    vtkNew<vtkGlyph3DMapper> mapper;
    mapper->SetInputData(places);
    mapper->SetSourceData(vtkMesh(sphereMesh(12)));
    mapper->SetScaleFactor(0.35);
    actors_[0]->SetMapper(mapper);
    expectBothAlike("glyphs");
}

TEST_F(VtkPasses, EdgesVerticesAndLines)
{
    vtkProperty* const property = actors_[0]->GetProperty();
    property->EdgeVisibilityOn();
    property->SetEdgeColor(0.9, 0.1, 0.2);
    expectBothAlike("edges");
    property->EdgeVisibilityOff();
    property->VertexVisibilityOn();
    property->SetPointSize(3.0f);
    property->SetVertexColor(0.1, 0.9, 0.2);
    expectBothAlike("vertices");
    property->VertexVisibilityOff();
    property->SetRepresentationToWireframe();
    expectBothAlike("wireframe", kLinesAndPoints);
    property->SetLineWidth(3.0f);
    property->RenderLinesAsTubesOn();
    expectBothAlike("tubes", kLinesAndPoints);
    property->RenderLinesAsTubesOff();
    property->SetRepresentationToPoints();
    property->SetPointSize(4.0f);
    property->RenderPointsAsSpheresOn();
    expectBothAlike("spheres", kLinesAndPoints);
    property->RenderPointsAsSpheresOff();
    property->SetRepresentationToSurface();
    property->LightingOff();
    expectBothAlike("not lit");
    property->LightingOn();
    property->SetInterpolationToFlat();
    expectBothAlike("flat");
}

/// Which cells are seen in the window.
std::vector<vtkIdType> seenCells(VtkView& view, vtkActor* actor)
{
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(&view.renderer());
    selector->SetArea(0, 0, kSize - 1, kSize - 1);
    selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
    vtkSmartPointer<vtkSelection> selection;
    selection.TakeReference(selector->Select());
    std::vector<vtkIdType> cells;
    for (unsigned int i = 0; i < selection->GetNumberOfNodes(); ++i) {
        vtkSelectionNode* const node = selection->GetNode(i);
        if (node->GetProperties()->Get(vtkSelectionNode::PROP()) != actor) continue;
        auto* ids = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
        for (vtkIdType k = 0; ids && k < ids->GetNumberOfValues(); ++k)
            cells.push_back(ids->GetValue(k));
    }
    return cells;
}

TEST_F(VtkPasses, HardwarePicksTheSameCells)
{
    const Bytes before = view_.bytes();
    const auto vtk = seenCells(view_, actors_[1]);
    EXPECT_GT(vtk.size(), 10u);
    for (const auto& actor : actors_) material_->ApplyTo(actor);
    view_.bytes();
    EXPECT_EQ(seenCells(view_, actors_[1]), vtk);
    EXPECT_LE(shareApart(view_.bytes(), before), kSilhouettes);
}

/// Of the left or the right half: sums of red, green and blue.
std::array<long, 3> halfOf(const Bytes& bytes, bool right)
{
    std::array<long, 3> sums{};
    for (size_t i = 0; i < bytes.size(); ++i)
        if ((i / 3 % kSize >= kSize / 2) == right) sums[i % 3] += bytes[i];
    return sums;
}

TEST_F(VtkPasses, SeveralRenderersEachHaveTheirLightsAndCamera)
{
    vtkNew<vtkRenderer> second;
    view_.renderer().SetViewport(0.0, 0.0, 0.5, 1.0);
    second->SetViewport(0.5, 0.0, 1.0, 1.0);
    second->SetActiveCamera(view_.renderer().GetActiveCamera());
    second->AddLight(vtkLightOf({Light::Type::directional, {-1.0f, 0.0f, 0.3f}, {0, 2.0f, 0}}));
    view_.window().AddRenderer(second);
    for (const auto& actor : actors_) material_->ApplyTo(actor);
    const auto leftAlone = halfOf(view_.bytes(), false);
    for (const auto& actor : actors_) second->AddActor(actor);
    const Bytes both = view_.bytes();
    EXPECT_EQ(halfOf(both, false), leftAlone);
    EXPECT_GT(leftAlone[0], 10000);
    EXPECT_EQ(halfOf(both, true)[0], 0);  // the second light is green
    EXPECT_GT(halfOf(both, true)[1], 10000);
    view_.renderer().RemoveAllViewProps();
    EXPECT_EQ(halfOf(view_.bytes(), true), halfOf(both, true));
}

TEST_F(VtkPasses, ASecondWindowHasTexturesOfItsOwn)
{
    VtkView other;
    for (const auto& actor : actors_) {
        vtkNew<vtkActor> copy;
        copy->ShallowCopy(actor);
        copy->SetMapper(vtkActorOf(vtkMesh(sphereMesh(12)))->GetMapper());
        material_->ApplyTo(copy);
        other.renderer().AddActor(copy);
    }
    other.renderer().AddLight(light_);
    const Bytes first = other.bytes();
    expectBothAlike("the first window");
    EXPECT_EQ(other.bytes(), first);
    EXPECT_GT(brightest(first), 60);
}

TEST_F(VtkPasses, AWindowThatIsFinalizedIsDrawnToAnew)
{
    for (const auto& actor : actors_) material_->ApplyTo(actor);
    const Bytes before = view_.bytes();
    view_.window().Finalize();
    view_.window().SetOffScreenRendering(1);
    EXPECT_EQ(view_.bytes(), before);
}

}  // namespace
}  // namespace fbrdf::test
