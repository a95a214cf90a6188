// With osgviewer --samples 4 a single pass is drawn, and passes that add up off screen are refused.
#include "OsgviewerTest.h"

namespace fbrdf::test {
namespace {

using MultisampledWindow = OsgviewerTest;

// Pixels of the outline of a ball, which several samples smooth.
constexpr size_t kOutline = 500;

Osgviewer::Options fourSamples()
{
    Osgviewer::Options options;
    options.arguments = "--samples 4";
    return options;
}

TEST_F(MultisampledWindow, ShowsTheMaterialInASinglePass)
{
    const std::string scene = written(groupOf({ball(0, osgFbrdf::kSinglePass)}));
    const auto node = read(scene);
    ViewerTwin twin(context().loader(), node, 160, 160);
    Osgviewer viewer(scene, fourSamples());
    expectSame(viewer, twin, "samples", kOutline);
    // This tests the test: the window is seen to have four samples.
    EXPECT_GT(pixelsApart(viewer.screen(), twin.frame()), kEdges);
    expectGoodEnd(viewer);
}

TEST_F(MultisampledWindow, ShowsTheFallbackWherePassesAddUp)
{
    const auto expected = read(written(groupOf({ball(0, osgFbrdf::kDiffuseFallback)})));
    ViewerTwin twin(context().loader(), expected, 160, 160);
    Osgviewer viewer(written(groupOf({ball(0, osgFbrdf::kTwoLookups)})), fourSamples());
    expectSame(viewer, twin, "samples-fallback", kOutline);
    EXPECT_EQ(viewer.quit(), 0);
    EXPECT_NE(viewer.output().find("noise0.fbrdf: diffuse fallback is drawn"), std::string::npos)
        << viewer.output();
    EXPECT_EQ(viewer.output().find("GL error"), std::string::npos) << viewer.output();
}

}  // namespace
}  // namespace fbrdf::test
