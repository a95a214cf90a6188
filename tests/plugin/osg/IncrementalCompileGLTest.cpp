// osgUtil::IncrementalCompileOperation visits what is to be compiled before any context is current,
// and compiles state sets and drawables over several frames, while nothing is drawn yet.
#include "EffectTest.h"

#include "support/gl/Scenes.h"

#include <osgUtil/IncrementalCompileOperation>

namespace fbrdf::test {
namespace {

using IncrementalCompile = EffectTest;

TEST_F(IncrementalCompile, LeavesAnEffectAsItIs)
{
    const osg::ref_ptr<osgUtil::IncrementalCompileOperation> compiler =
        new osgUtil::IncrementalCompileOperation;
    view_->viewer().setIncrementalCompileOperation(compiler);
    const osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(osgLights(testLights(9)));
    view_->setScene(root);
    view_->frame();
    const auto effect = osgEffect(testMaterials()[0], sphereMesh(24));
    const Notices notices;
    compiler->add(root, effect);
    int frames = 0;
    for (; frames < 100 && effect->getNumParents() == 0; ++frames) view_->frame();
    ASSERT_EQ(effect->getNumParents(), 1u) << "after " << frames << " frames";
    const auto first = view_->frame();
    EXPECT_GT(meanOf(first, 3), 0.3);
    EXPECT_EQ(view_->frame(), first);
    EXPECT_EQ(effect->lastReport().technique, "single pass");
    EXPECT_EQ(notices.text(), "");
    // The pictures are those without the operation.
    const auto twin = osgEffect(testMaterials()[0], sphereMesh(24));
    view_->viewer().setIncrementalCompileOperation(nullptr);
    scene(twin, osgLights(testLights(9)));
    EXPECT_EQ(view_->frame(), first);
}

}  // namespace
}  // namespace fbrdf::test
