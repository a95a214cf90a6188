// With osgviewer --samples 4 edges are smooth in a single pass, and where passes add up off screen.
#include "OsgviewerTest.h"

namespace fbrdf::test {
namespace {

// Pixels of the outline of a ball, which several samples smooth.
constexpr size_t kOutline = 500;

Osgviewer::Options fourSamples()
{
    Osgviewer::Options options;
    options.arguments = "--samples 4";
    return options;
}

class SampledTechniques : public OsgviewerTest, public ::testing::WithParamInterface<int> {};

TEST_P(SampledTechniques, ShowTheMaterialWithSmoothEdges)
{
    const std::string scene = written(groupOf({ball(0, GetParam())}));
    const auto node = read(scene);
    ViewerTwin twin(context().loader(), node, 160, 160);
    Osgviewer viewer(scene, fourSamples());
    expectSame(viewer, twin, "samples", kOutline);
    // This tests the test: the window is seen to have four samples.
    EXPECT_GT(pixelsApart(viewer.screen(), twin.frame()), kEdges);
    expectGoodEnd(viewer);
}

std::string sampledName(const ::testing::TestParamInfo<int>& technique)
{
    return technique.param == osgFbrdf::kSinglePass ? "InASinglePass" : "WherePassesAddUp";
}

INSTANTIATE_TEST_SUITE_P(MultisampledWindow, SampledTechniques,
                         ::testing::Values(osgFbrdf::kSinglePass, osgFbrdf::kTwoLookups),
                         sampledName);

}  // namespace
}  // namespace fbrdf::test
