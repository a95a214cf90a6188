// The effect receives the shadows of osgShadow: a ball hangs over a floor of the effect, and a
// technique shadows a lamp. Rays say where the shadow must be; there the picture must lack the
// light of the lamp and nothing else.
#include "Pictures.h"
#include "ShadowScene.h"
#include "ShadowTechniques.h"

#include "support/gl/CompareImages.h"
#include "support/gl/Scenes.h"

#include <functional>

namespace fbrdf::test {
namespace {

/// True where the ray from there meets the ball.
bool meetsBall(const glm::dvec3& from, const glm::dvec3& direction)
{
    const glm::dvec3 d = glm::normalize(direction), toBall = kBall - from;
    const double along = glm::dot(toBall, d);
    return along > 0.0 && glm::dot(toBall, toBall) - along * along < kBallRadius * kBallRadius;
}

/// The point of the floor at a place of the picture, in pixels; the ball before it hides it.
struct Seen {
    glm::dvec3 point;
    bool isFloor = false;
};
Seen seenAt(double x, double y)
{
    const gl::View view = perspectiveView();
    const glm::dmat4 toWorld = glm::inverse(glm::dmat4(view.projection) * glm::dmat4(view.view));
    const glm::dvec4 ndc(2.0 * x / kSize - 1.0, 2.0 * y / kSize - 1.0, 1.0, 1.0);
    const glm::dvec4 beyond = toWorld * ndc;
    const glm::dvec3 eye(glm::inverse(glm::dmat4(view.view))[3]);
    const glm::dvec3 ray = glm::dvec3(beyond) / beyond.w - eye;
    const glm::dvec3 point = eye + ray * ((kFloor - eye.z) / ray.z);
    return {point, !meetsBall(eye, ray) && std::abs(point.x) < kHalf && std::abs(point.y) < kHalf};
}

class ShadowsReceived : public FloorTest, public ::testing::WithParamInterface<ShadowKind> {
protected:
    void SetUp() override
    {
        FloorTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        ball_ = ballOverFloor();
        // Most techniques draw back faces into their maps, of models that have these culled.
        for (osg::Node* node : {static_cast<osg::Node*>(effect_.get()), ball_.get()})
            node->getOrCreateStateSet()->setMode(GL_CULL_FACE, osg::StateAttribute::ON);
        // The unit is that of the map, which must stay there.
        if (!GetParam().shadowsAll)
            effect_->getChild(0)->getOrCreateStateSet()->setTextureAttribute(1, new osg::Texture2D);
        if (!GetParam().dividesScene) return;
        effect_->setNodeMask(kReceives);
        ball_->setNodeMask(kCasts);
    }

    /// Lights, ball and floor below a scene with shadows, or below a group.
    Picture picture(const std::vector<osg::ref_ptr<osg::Light>>& lamps, osg::Node* points,
                    bool shadowed)
    {
        osg::ref_ptr<osg::Group> root = new osg::Group;
        if (shadowed) root = shadowedScene(GetParam(), techniques_);
        for (const auto& lamp : lamps) root->addChild(sourceOf(lamp));
        if (points) root->addChild(points);
        root->addChild(effect_);
        root->addChild(ball_);
        view_->setScene(root);
        for (int frame = 0; frame < 2; ++frame) view_->draw();
        const Picture image = view_->frame();
        view_->setScene(nullptr);
        return image;
    }

    osg::ref_ptr<osg::Node> ball_;
};

using TowardsLight = std::function<glm::dvec3(const glm::dvec3& point)>;
TowardsLight towards(const osg::Light& light, bool aims)
{
    const osg::Vec4f& p = light.getPosition();
    const bool isFar = aims || p.w() == 0.0f;
    const osg::Vec3d v(aims ? -light.getDirection() : osg::Vec3f(p.x(), p.y(), p.z()));
    const glm::dvec3 place(v.x(), v.y(), v.z());
    return [=](const glm::dvec3& point) { return isFar ? place : place - point; };
}

enum class Shade { lit, dark, edge, hidden };

/// What rays say of a pixel; width: of the edge, in pixels to either side.
Shade shadeOf(int x, int y, const TowardsLight& toLight, double width)
{
    int dark = 0, all = 0;
    for (int j = -3; j <= 3; ++j)
        for (int i = -3; i <= 3; ++i) {
            const Seen seen = seenAt(x + 0.5 + i * width / 3.0, y + 0.5 + j * width / 3.0);
            if (!seen.isFloor) return Shade::hidden;
            dark += meetsBall(seen.point, toLight(seen.point)) ? 1 : 0;
            ++all;
        }
    return dark == 0 ? Shade::lit : dark == all ? Shade::dark : Shade::edge;
}

/// Compares pictures where rays leave no doubt.
struct Comparison {
    int lit = 0, dark = 0, wrong = 0, between = 0;
};

struct Pictures {
    Picture lamp, second, points, all;
};

Comparison compared(const Pictures& pictures, const osg::Light& lamp, const osg::Light& second,
                    const ShadowKind& kind)
{
    const double width = kind.isSoft ? 3.5 : 2.0;
    Comparison result;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const Shade first = shadeOf(x, y, towards(lamp, kind.aims), width),
                        other = kind.shadowsAll ? shadeOf(x, y, towards(second, kind.aims), width)
                                                : Shade::lit;
            if (first == Shade::hidden) continue;
            const auto i = static_cast<size_t>(4 * (y * kSize + x));
            const float without = pictures.second[i] + pictures.points[i],
                        with = without + pictures.lamp[i], found = pictures.all[i];
            if (first == Shade::edge) {
                const float share = (found - without) / pictures.lamp[i];
                result.between += share > 0.1f && share < 0.9f ? 1 : 0;
                continue;
            }
            if (other == Shade::edge) continue;
            const float expected = (first == Shade::dark ? without : with) -
                                   (other == Shade::dark ? pictures.second[i] : 0.0f);
            ++(first == Shade::dark ? result.dark : result.lit);
            result.wrong += std::abs(found - expected) > 0.01f * with ? 1 : 0;
        }
    return result;
}

struct Way {
    const char* name;
    int technique;
    bool surfaces;
};
constexpr Way kWays[] = {{"single", osgFbrdf::kSinglePass, false},
                         {"batched", osgFbrdf::kBatched, false},
                         {"two", osgFbrdf::kTwoLookups, false},
                         {"surfaces", osgFbrdf::kTwoLookups, true}};

TEST_P(ShadowsReceived, LackTheLightOfTheLampAndNothingElse)
{
    const ShadowKind& kind = GetParam();
    const osg::ref_ptr<osg::Node> points = osgLights(testLights(3));
    const auto second = osgLight(1, {-0.7f, 0.4f, 1.4f, 0.0f});
    effect_->setLightsPerPass(2);
    for (const osg::Vec4f& place : {osg::Vec4f(0.8f, 0.5f, 1.2f, 0.0f), {1.4f, 0.8f, 2.5f, 1.0f}}) {
        const auto lamp = osgLight(0, place);
        lamp->setDirection(-osg::Vec3f(place.x(), place.y(), place.z()));
        for (const Way& way : kWays) {
            effect_->setFloatTarget(!way.surfaces);
            effect_->selectTechnique(way.technique);
            const Notices notices;
            Pictures pictures{picture({lamp}, nullptr, false),
                              picture({second}, nullptr, false),
                              picture({}, points, false),
                              {}};
            pictures.all = picture({second, lamp}, points, true);
            keepPicture(pictures.all, kSize,
                        std::string("received-") + kind.name + "-" + way.name +
                            (place.w() == 0.0f ? "-far" : "-near"));
            const Comparison found = compared(pictures, *lamp, *second, kind);
            EXPECT_GT(found.dark, kind.isSoft ? 20 : 50) << way.name;
            EXPECT_GT(found.lit, 600) << way.name;
            EXPECT_LE(found.wrong, 3) << way.name << " " << place.w();
            EXPECT_GE(found.between, kind.isSoft ? 40 : 0) << way.name;
            EXPECT_EQ(effect_->lastReport().reason, "");
            EXPECT_EQ(effect_->lastReport().whyNoShadows, "");
            EXPECT_GT(effect_->lastReport().shadowMaps, 0);
            EXPECT_EQ(notices.text(), "");
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Techniques, ShadowsReceived, ::testing::ValuesIn(shadowKinds()),
                         [](const ::testing::TestParamInfo<ShadowKind>& kind) {
                             return std::string(kind.param.name);
                         });

}  // namespace
}  // namespace fbrdf::test
