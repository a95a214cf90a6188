// Many threads cull one effect for the first time at once: osgFX defines techniques without a lock,
// and state sets are made when they are first needed.
#include "OsgScene.h"

#include "support/gl/Scenes.h"

#include <osg/Viewport>
#include <osgUtil/CullVisitor>
#include <osgUtil/Statistics>

#include <OpenThreads/Barrier>

#include <set>
#include <thread>

namespace fbrdf::test {
namespace {

using osgFbrdf::FactorizedBrdf;

constexpr int kThreads = 8, kRounds = 60;

/// The state sets that a cull collected for drawing.
struct Culled {
    int drawables = 0, bins = 0, stateSets = 0;
    std::set<const osg::StateSet*> constant;  ///< state sets with a program
    bool operator==(const Culled& other) const
    {
        return drawables == other.drawables && bins == other.bins && stateSets == other.stateSets &&
               constant == other.constant;
    }
};

void collect(const osgUtil::StateGraph& graph, Culled& culled)
{
    for (const auto& [state, child] : graph._children) {
        ++culled.stateSets;
        if (state->getAttribute(osg::StateAttribute::PROGRAM)) culled.constant.insert(state);
        collect(*child, culled);
    }
}

/// Culls as osgUtil::SceneView does, but without a context.
Culled cull(osg::Node& scene, osg::FrameStamp& stamp)
{
    const osg::ref_ptr<osgUtil::CullVisitor> visitor = osgUtil::CullVisitor::create();
    const osg::ref_ptr<osgUtil::StateGraph> graph = new osgUtil::StateGraph;
    const osg::ref_ptr<osgUtil::RenderStage> stage = new osgUtil::RenderStage;
    const osg::ref_ptr<osg::Viewport> viewport = new osg::Viewport(0, 0, kSize, kSize);
    const gl::View view = perspectiveView();
    visitor->setFrameStamp(&stamp);
    visitor->setStateGraph(graph);
    visitor->setRenderStage(stage);
    visitor->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    visitor->pushViewport(viewport);
    visitor->pushProjectionMatrix(new osg::RefMatrix(osgMatrix(view.projection)));
    visitor->pushModelViewMatrix(new osg::RefMatrix(osgMatrix(view.view)),
                                 osg::Transform::ABSOLUTE_RF);
    scene.accept(*visitor);
    visitor->popModelViewMatrix();
    visitor->popProjectionMatrix();
    visitor->popViewport();
    osgUtil::Statistics statistics;
    stage->getStats(statistics);
    Culled culled;
    culled.drawables = statistics.numDrawables;
    culled.bins = statistics.nbins;
    collect(*graph, culled);
    return culled;
}

TEST(FirstCull, ByManyThreadsAtOnceIsAsByOne)
{
    const osg::ref_ptr<osg::Geometry> sphere = osgMesh(sphereMesh(6));
    const Notices notices;
    for (int round = 0; round < kRounds; ++round) {
        const osg::ref_ptr<FactorizedBrdf> effect = new FactorizedBrdf;
        const auto materials = testMaterials();
        effect->setMaterial(
            new osgFbrdf::MaterialObject(materials[static_cast<size_t>(round) % materials.size()]));
        if (round % 3 == 0) effect->selectTechnique(osgFbrdf::kTwoLookups);
        effect->addChild(sphere);
        const osg::ref_ptr<osg::Group> scene = new osg::Group;
        scene->addChild(effect);
        scene->addChild(osgLights(testLights(9)));
        scene->getBound();  // as a viewer asks before threads begin
        const osg::ref_ptr<osg::FrameStamp> stamp = new osg::FrameStamp;
        OpenThreads::Barrier start(kThreads);
        std::vector<Culled> culled(kThreads);
        std::vector<std::thread> threads;
        for (Culled& mine : culled)
            threads.emplace_back([&] {
                start.block();
                mine = cull(*scene, *stamp);
            });
        for (std::thread& thread : threads) thread.join();
        EXPECT_EQ(effect->getNumTechniques(), 4);
        const Culled again = cull(*scene, *stamp);
        EXPECT_GT(again.drawables, 0);
        EXPECT_GT(again.constant.size(), 0u);
        for (const Culled& each : culled) EXPECT_TRUE(each == again) << "round " << round;
    }
    EXPECT_EQ(notices.text(), "");
}

}  // namespace
}  // namespace fbrdf::test
