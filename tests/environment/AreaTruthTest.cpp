#include <fbrdf/environment/AreaTruth.h>
#include <fbrdf/plan/AreaContour.h>

#include <gtest/gtest.h>

#include "plan/AreaShapes.h"

#include <cmath>

namespace fbrdf {
namespace {

using Shape = AreaLight::Shape;

const ShadingFrame<double> kUp{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

// A white diffuse surface, whose lobe is exact: points of the light against its outline.
TEST(AreaTruth, OfDiffuseSurfacesIsTheFormFactor)
{
    constexpr double kPoints = 2e-3;
    const Reflectance white = [](const Vec3d&, const Vec3d&) { return Vec3d(1.0 / kPi); };
    LobeSum<double> lobes;
    lobes.cosine = Vec3d(1.0);
    for (const Shape shape :
         {Shape::sphere, Shape::disc, Shape::rectangle, Shape::tube, Shape::polygon})
        for (const bool twoSided : {false, true})
            for (const float radius : {0.0f, 3.0f}) {
                AreaLight light = ofShape(shape);
                light.radiance = {1, 2, 3};
                light.twoSided = twoSided;
                light.radius = radius;
                std::vector<AreaVectors> vectors;
                appendAreaVectors(light, 0, glm::dmat4(1.0), vectors);
                for (const Vec3d& position :
                     {Vec3d(0.0), Vec3d(0.5, 0.5, 0.8), Vec3d(-1, 0, 1.7)}) {
                    Vec3d expected(0.0);
                    for (const AreaVectors& v : vectors)
                        expected += areaReflected(lobes, kUp, v, position);
                    const Vec3d found = AreaTruth(light).reflected(white, position, kUp, {0, 0, 1});
                    for (int c = 0; c < 3; ++c)
                        EXPECT_NEAR(found[c], expected[c], kPoints * (1 + c))
                            << shapeName(shape) << " at " << position.x;
                }
            }
}

TEST(AreaTruth, VisitsMorePointsNearTheMirrorDirection)
{
    int calls = 0;
    const Reflectance counted = [&calls](const Vec3d&, const Vec3d&) {
        ++calls;
        return Vec3d(0.1);
    };
    const AreaTruth truth(ofShape(Shape::sphere), {1024, 4096});
    truth.reflected(counted, Vec3d(0.0), kUp, glm::normalize(Vec3d(-0.3, -0.2, 1.5)));
    EXPECT_EQ(calls, 4096);
    calls = 0;
    truth.reflected(counted, Vec3d(0.0), kUp, glm::normalize(Vec3d(0.9, 0.2, 0.4)));
    EXPECT_EQ(calls, 1024);
}

TEST(AreaTruth, FromInsideIsTheAlbedo)
{
    const Reflectance white = [](const Vec3d&, const Vec3d&) { return Vec3d(1.0 / kPi); };
    AreaLight light = ofShape(Shape::sphere);
    light.radiance = {1, 2, 3};
    const Vec3d found = AreaTruth(light).reflected(white, Vec3d(light.position), kUp, {0, 0, 1});
    EXPECT_NEAR(found.y, 2.0, 1e-3);
}

}  // namespace
}  // namespace fbrdf
