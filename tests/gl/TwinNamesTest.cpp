// A GLSL function fbrdfX and the C++ function x compute the same, step by step. TwinGLTest.cpp and
// TwinLightGLTest.cpp compare their values; this file checks that both exist under these names and
// that no function of the shader snippets was forgotten.
#include <fbrdf/brdf/LobeContour.h>
#include <fbrdf/brdf/LobeSampling.h>
#include <fbrdf/brdf/Projection.h>
#include <fbrdf/brdf/SampleLattice.h>
#include <fbrdf/brdf/ShadingFrame.h>
#include <fbrdf/environment/Prefilter.h>
#include <fbrdf/plan/AreaContour.h>
#include <fbrdf/plan/LightClusters.h>
#include <fbrdf/plan/Transfer.h>
#include <fbrdf/shaders/ShaderSource.h>

#include "ClusterGeometry.h"

#include <gtest/gtest.h>

#include <cctype>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>

namespace fbrdf {
namespace {

using Names = std::set<std::string>;

/// "fbrdfDiscPosition" from "&discPosition<float>".
std::string glslName(std::string cpp)
{
    cpp = std::regex_replace(cpp, std::regex("<[a-z]*>"), "");
    cpp = std::regex_replace(cpp, std::regex(".*[:&]"), "");
    return "fbrdf" + std::string(1, static_cast<char>(std::toupper(cpp[0]))) + cpp.substr(1);
}

// The address compiles only if the C++ function exists.
#define FBRDF_TWIN(function) (static_cast<void>(function), glslName(#function))

Names twins()
{
    return {FBRDF_TWIN(&axisCoordinate<float>),
            FBRDF_TWIN(&discPosition<float>),
            FBRDF_TWIN(&combination<float>),
            FBRDF_TWIN(&differenceVector<float>),
            FBRDF_TWIN(&shadingFrame<float>),
            FBRDF_TWIN(&perturbed<float>),
            FBRDF_TWIN(&ShadingFrame<float>::local),
            FBRDF_TWIN(&falloff<float>),
            FBRDF_TWIN(&influenceWindow<float>),
            FBRDF_TWIN(&levelMixture<float>),
            FBRDF_TWIN(&angleOverSine<float>),
            FBRDF_TWIN(&lobeEdge<float>),
            FBRDF_TWIN(&lobeInCap<float>),
            FBRDF_TWIN(&areaContour<float>),
            FBRDF_TWIN(&contourPoint<float>),
            FBRDF_TWIN(&lobeInArea<float>),
            FBRDF_TWIN(&intervalDistance<float>),
            FBRDF_TWIN(&tileExtent<float>),
            FBRDF_TWIN(&coneBounds<float>),
            FBRDF_TWIN(&coneFactor),
            FBRDF_TWIN(&lightList),
            FBRDF_TWIN(&lobeFrame),
            FBRDF_TWIN(&lobesAt<float>),
            FBRDF_TWIN(&lobeMixture<float>),
            FBRDF_TWIN(&sampleMixture<float>),
            FBRDF_TWIN(&mixturePdf<float>),
            FBRDF_TWIN(&sampleLobes<float>),
            FBRDF_TWIN(&lobePdf<float>),
            FBRDF_TWIN(&samplePoint<float>),
            FBRDF_TWIN(&levelOfCell),
            FBRDF_TWIN(&srgbFromLinear<float>),
            FBRDF_TWIN(&toneMapped<float>)};
}

/// Members of PairGeometry.
const Names kAngles{"fbrdfHalfVector",
                    "fbrdfZenith",
                    "fbrdfDifferenceAngle",
                    "fbrdfDifferenceAzimuth",
                    "fbrdfHalfDifferenceAzimuth",
                    "fbrdfSideDifferenceAzimuth"};

/// Functions that exist in GLSL alone, and why.
const std::map<std::string, std::string> kAlone{
    {"fbrdfAngleFromCosine", "a step of every angle"},
    {"fbrdfZenithAbout", "fbrdfZenith without a tangent frame"},
    {"fbrdfHalfZenith", "fbrdfZenith of h, without h"},
    {"fbrdfHalfAngle", "a step of half_phi_d and side_phi_d"},
    {"fbrdfSizeOf", "a step of h, theta_h, theta_d and phi_d"},
    {"fbrdfToLight", "a step of fbrdfIrradiance"},
    {"fbrdfIrradiance", "falloff and coneFactor of one light"},
    {"fbrdfFromLocal", "the inverse of fbrdfLocal"},
    {"fbrdfThetaPosition", "a step of lobesAt"},
    {"fbrdfAzimuthPosition", "a step of lobesAt"},
    {"fbrdfLobeKnot", "a step of lobesAt"},
    {"fbrdfTiltedAxis", "a step of lobesAt"},
    {"fbrdfBentAxis", "a step of lobesAt"},
    {"fbrdfLobeRow", "a step of lobesAt"},
    {"fbrdfSampledWidths", "a step of lobeMixture"},
    {"fbrdfPartAxes", "a step of lobeMixture"},
    {"fbrdfStretchedDensity", "a step of mixturePdf"},
    {"fbrdfFacePoint", "EnvironmentMakingGLTest.cpp compares the cube"},
    {"fbrdfStorable", "what a format can store"},
    {"fbrdfBulge", "a step of areaContour"},
    {"fbrdfWholeCircle", "a step of areaContour"},
    {"fbrdfSphereContour", "a step of areaContour"},
    {"fbrdfTubeContour", "a step of areaContour"},
    {"fbrdfFacetContour", "a step of areaContour"},
    {"fbrdfSquaredDistance", "a step of areaContour"},
    {"fbrdfCutEdge", "a step of lobeInArea"},
    {"fbrdfLobeInOutline", "a step of lobeInArea"},
    {"fbrdfListed", "reads what fbrdfLightList found"},
    {"fbrdfReaches", "skips lights of a list"},
    {"fbrdfWaitForAll", "a barrier of a work group"},
    {"fbrdfVectorsOf", "where ClusterWork.h has a light"},
    {"fbrdfBoundsOf", "coneBounds of one light"},
};

Names definedFunctions()
{
    const std::regex definition("\n[A-Za-z0-9]+ (fbrdf[A-Za-z]+)\\(");
    Names names;
    for (const char* file :
         {"angles.glsl", "area.glsl", "cluster_geometry.glsl", "cluster_lists.comp",
          "clusters.glsl", "frame.glsl", "lights.glsl", "lobe_frame.glsl", "lobes.glsl",
          "prefilter.glsl", "projection.glsl", "samples.glsl", "sampling.glsl", "transfer.glsl"}) {
        const std::string text(shaderSnippet(file));
        EXPECT_FALSE(text.empty()) << file;
        for (std::sregex_iterator i(text.begin(), text.end(), definition), end; i != end; ++i)
            names.insert((*i)[1]);
    }
    return names;
}

TEST(TwinNames, EveryTwinExistsInGlsl)
{
    const Names defined = definedFunctions();
    for (const Names& names : {twins(), kAngles})
        for (const std::string& name : names) EXPECT_EQ(defined.count(name), 1u) << name;
    for (const auto& [name, reason] : kAlone) EXPECT_EQ(defined.count(name), 1u) << name;
}

TEST(TwinNames, EveryGlslFunctionHasATwinOrAReason)
{
    for (const std::string& name : definedFunctions())
        EXPECT_EQ(twins().count(name) + kAngles.count(name) + kAlone.count(name), 1u)
            << name << " needs a C++ twin of that name, or an entry in kAlone";
}

// fbrdfLightList reads buffers; ManyLightsGLTest.cpp compares it by pictures. What draws directions
// is compared by SamplingGLTest.cpp, where sampleLobes and lobePdf consist of the others, and by
// the pictures of SampledEnvironmentGLTest.cpp.
TEST(TwinNames, EveryTwinIsCompared)
{
    std::string text;
    for (const char* const name : {"tests/gl/TwinGLTest.cpp", "tests/gl/TwinLightGLTest.cpp"}) {
        std::ifstream file(name);
        ASSERT_TRUE(file) << name;
        text.append(std::istreambuf_iterator<char>(file), {});
    }
    Names compared = twins();
    compared.insert(kAngles.begin(), kAngles.end());
    for (const char* const elsewhere : {"fbrdfLightList", "fbrdfSamplePoint", "fbrdfLevelOfCell",
                                        "fbrdfLobesAt", "fbrdfLobeMixture", "fbrdfSampleMixture",
                                        "fbrdfMixturePdf", "fbrdfSampleLobes", "fbrdfLobePdf"})
        compared.erase(elsewhere);
    for (const std::string& name : compared)
        EXPECT_NE(text.find(name + "("), std::string::npos) << name;
}

TEST(TwinNames, AreFoundFromTheCppName)
{
    EXPECT_EQ(glslName("&axisCoordinate<float>"), "fbrdfAxisCoordinate");
    EXPECT_EQ(glslName("&fbrdf::falloff<float>"), "fbrdfFalloff");
}

}  // namespace
}  // namespace fbrdf
