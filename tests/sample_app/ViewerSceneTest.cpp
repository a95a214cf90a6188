// ViewerSceneTest.cpp - what fbrdf-viewer shows around the objects: ground, shadows, samples,
// background; and that nothing of it is there unless it is asked for.
#include "ViewerFixture.h"

#include <fbrdf/scene/Ground.h>
#include <fbrdf/scene/Layout.h>
#include <fbrdf/scene/Lights.h>

#include <cmath>

namespace fbrdf::scene {
namespace {

/// How far two pictures of a scene are apart where edges, of shadows and objects, count little.
struct Apart {
    double mean = 0.0, largest = 0.0;  ///< of |a - b|, over the mean of b
    double coverage = 0.0;             ///< mean of |a - b| of alpha
};
Apart apart(const Image& a, const Image& b)
{
    Apart result;
    double sum = 0.0;
    for (size_t i = 0; i < a.rgba.size(); ++i) {
        const double off = std::abs(double(a.rgba[i]) - double(b.rgba[i]));
        if (i % 4 == 3) {
            result.coverage += off / double(a.pixelCount());
        } else {
            result.mean += off;
            result.largest = std::max(result.largest, off);
            sum += double(b.rgba[i]);
        }
    }
    const double mean = sum / (3.0 * double(a.pixelCount()));
    return {result.mean / sum, result.largest / mean, result.coverage};
}

class ViewerScene : public Viewer {
protected:
    /// A material that is drawn alike by all techniques, two lights, and a view of ground and
    /// shadows.
    std::string stage() const
    {
        return drawMade() + "--mesh sphere --light-count 2 --camera 0,2,5,0,-0.3,0,40 ";
    }
};

TEST_F(ViewerScene, APlainPictureIsWhatTheRuntimeDraws)
{
    NEEDS(Backend::egl);
    const Material material = madeMaterial(formPqp(16, 0.5));
    const Mesh mesh = makeSphere();
    Scene scene;
    scene.instances = {{&mesh}};
    scene.lights = makeLights(5);
    scene.view = viewFromCamera(Camera(), 1.0, boundsOf(mesh));
    GlPictures pictures(Backend::egl);
    const Image expected = pictures.draw(scene, material, Technique::single, 48, 48).image;
    EXPECT_EQ(draw(drawMade()).rgba, expected.rgba);
    EXPECT_EQ(draw(drawMade() + "--plain").rgba, expected.rgba);
    EXPECT_EQ(stats_["samples"], 1);
    EXPECT_EQ(stats_["ground"], false);
    EXPECT_EQ(stats_["shadows"], false);
    EXPECT_EQ(draw(drawMade() + "--samples 1 --background none").rgba, expected.rgba);
    EXPECT_NE(draw(drawMade() + "--samples 2").rgba, expected.rgba) << "the tester";
}

TEST_F(ViewerScene, EveryTechniqueDrawsGroundAndShadowsAsTheReferenceDoes)
{
    NEEDS(Backend::egl);
    const std::string scene = stage() + "--ground --shadows --samples 4 ";
    const Image reference = draw(scene + "--technique reference");
    for (const char* technique : {"single", "batched", "two-lookup"}) {
        SCOPED_TRACE(technique);
        const Apart off = apart(draw(scene + "--technique " + technique), reference);
        EXPECT_LT(off.mean, 0.02) << "edges of shadows";
        EXPECT_LT(off.coverage, 1e-3);
        EXPECT_EQ(stats_["technique_drawn"], technique);
    }
    const Apart vertex = apart(draw(scene + "--technique vertex"), reference);
    EXPECT_LT(vertex.mean, 0.03);
    EXPECT_LT(vertex.coverage, 1e-6);
    // Paths have shadows of points and light from surface to surface, but for these they agree.
    const Apart path = apart(draw(scene + "--technique path --bounces 0"), reference);
    EXPECT_LT(path.mean, 0.03);
    EXPECT_LT(path.coverage, 1e-6);
    // The tester: without shadows or without ground it is another picture.
    EXPECT_GT(apart(draw(stage() + "--ground --samples 4"), reference).mean, 0.04);
    EXPECT_GT(apart(draw(stage() + "--shadows --samples 4"), reference).coverage, 0.2);
}

TEST_F(ViewerScene, TheGroundTakesAContactShadowFromTheEnvironment)
{
    NEEDS(Backend::egl);
    Image white(8, 4);
    std::fill(white.rgba.begin(), white.rgba.end(), 1.0f);
    writeImage(white, file("white.exr"), 1.0f);
    const std::string scene = drawMade() +
                              "--light-count 0 --camera 0,6,0.01,0,-1,0,30 --environment '" +
                              file("white.exr") + "' --ground ";
    const Image image = draw(scene);
    // Beside the sphere, seen from above: kAlbedo of what a white sky sends, less 1 / d^3 of it.
    const double pixel = 2.0 * 7.0 * std::tan(15.0 * kDegree) / 48.0;  // on the ground
    for (const int x : {4, 8, 40, 44}) {
        const double across = pixel * (x + 0.5 - 24.0);
        const double expected = Ground::kAlbedo * (1.0 - std::pow(1.0 + across * across, -1.5));
        EXPECT_NEAR(image.pixel(x, 24)[1], expected, 0.02) << x;
    }
    const Apart off = apart(draw(scene + "--technique reference"), image);
    EXPECT_LT(off.mean, 0.05) << "lobes against all texels";
}

TEST_F(ViewerScene, FromBelowTheGroundIsNotDrawn)
{
    NEEDS(Backend::egl);
    const std::string below = drawMade() + "--camera 0,-2,4,0,0,0,35 ";
    for (const char* technique : {"single", "reference", "path --bounces 0"}) {
        SCOPED_TRACE(technique);
        const std::string scene = below + "--technique " + technique;
        const Image with = draw(scene + " --ground"), without = draw(scene);
        for (size_t i = 3; i < with.rgba.size(); i += 4) ASSERT_EQ(with.rgba[i], without.rgba[i]);
    }
}

TEST_F(ViewerScene, SamplesGiveEdgesGradesInEveryTechnique)
{
    NEEDS(Backend::egl);
    const std::string scene = drawMade() + "--light-count 2 --samples 16 ";
    const Image reference = draw(scene + "--technique reference");
    int grades = 0;
    for (size_t i = 3; i < reference.rgba.size(); i += 4)
        grades += reference.rgba[i] > 0.0f && reference.rgba[i] < 1.0f;
    EXPECT_GT(grades, 80) << "the outline of the disc";
    for (const char* technique : {"single", "batched", "two-lookup", "vertex"}) {
        SCOPED_TRACE(technique);
        const Apart off = apart(draw(scene + "--technique " + technique), reference);
        EXPECT_LT(off.coverage, 1e-4);
        EXPECT_LT(off.mean, std::string(technique) == "vertex" ? 0.03 : 2e-3);
    }
}

TEST_F(ViewerScene, TheBackgroundShowsThroughEdgesAndTheFadingGround)
{
    NEEDS(Backend::egl);
    const std::string scene = stage() + "--ground --samples 4 ";
    const Image black = draw(scene), grey = draw(scene + "--background 0.5,0.25,1");
    for (size_t i = 0; i < grey.rgba.size(); i += 4) {
        const float open = 1.0f - black.rgba[i + 3];
        EXPECT_EQ(grey.rgba[i + 3], black.rgba[i + 3]);
        EXPECT_NEAR(grey.rgba[i], black.rgba[i] + 0.5f * open, 1e-6f);
        EXPECT_NEAR(grey.rgba[i + 2], black.rgba[i + 2] + open, 1e-6f);
    }
}

TEST_F(ViewerScene, TheFullSceneCanDoWithoutAnEnvironment)
{
    const Image image =
        draw(drawMade() + "--full --environment none --technique vertex --samples 1");
    EXPECT_TRUE(stats_["environment"].is_null());
    EXPECT_EQ(image.pixel(0, 0)[1], 0.0f) << "no background";
    EXPECT_GT(image.pixel(24, 47)[1], 0.0f) << "the ground";
}

TEST_F(ViewerScene, TheFullSceneHasAllOfItAndLetsOptionsChangeIt)
{
    NEEDS(Backend::egl);
    const Image full = draw(
        "--headless --size 48x48 --material lambert:albedo=0.5 --form hdio --full --light-count 3");
    EXPECT_EQ(stats_["environment"]["name"], "studio");
    EXPECT_EQ(stats_["lights"]["given"], 3);
    EXPECT_EQ(stats_["samples"], 16);
    EXPECT_EQ(stats_["ground"], true);
    EXPECT_EQ(stats_["shadows"], true);
    EXPECT_GT(full.pixel(0, 47)[3], 0.5f) << "the ground";
    EXPECT_GT(full.pixel(0, 0)[1], 0.01f) << "the background";
}

}  // namespace
}  // namespace fbrdf::scene
