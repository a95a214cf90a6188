// OSG hands geometries over to OpenGL in several ways, and a user's model may use any of them.
#include "EffectTest.h"

#include "support/gl/Scenes.h"

#include <osg/DisplaySettings>

namespace fbrdf::test {
namespace {

enum class Form { displayList, vertexArrays, buffers, arrayObject };

void setForm(osg::Geometry& geometry, Form form)
{
    geometry.setUseDisplayList(form == Form::displayList);
    geometry.setUseVertexBufferObjects(form == Form::buffers || form == Form::arrayObject);
    geometry.setUseVertexArrayObject(form == Form::arrayObject);
}

class GeometryForms : public EffectTest {
protected:
    /// Draws by every technique, before and after OpenGL's objects are made anew.
    void expectSame(OsgView& view, const std::vector<std::vector<float>>& expected, Form form)
    {
        const auto effect = osgEffect(testMaterials()[0], sphereMesh(24));
        setForm(*effect->getChild(0)->asGeometry(), form);
        const osg::ref_ptr<osg::Group> root = new osg::Group;
        root->addChild(effect);
        root->addChild(osgLights(testLights(9)));
        view.setScene(root);
        const Notices notices;
        for (const bool released : {false, true}) {
            if (released) root->releaseGLObjects();
            for (size_t technique = 0; technique < expected.size(); ++technique) {
                effect->selectTechnique(static_cast<int>(technique));
                for (int frame = 0; frame < 2; ++frame)
                    EXPECT_EQ(view.frame(), expected[technique])
                        << "form " << static_cast<int>(form) << ", technique " << technique
                        << (released ? ", released" : "");
            }
        }
        EXPECT_EQ(notices.text(), "");
    }
    std::vector<std::vector<float>> images()
    {
        const auto effect = osgEffect(testMaterials()[0], sphereMesh(24));
        scene(effect, osgLights(testLights(9)));
        std::vector<std::vector<float>> images;
        for (int technique = 0; technique <= osgFbrdf::kDiffuseFallback; ++technique) {
            effect->selectTechnique(technique);
            images.push_back(view_->frame());
        }
        return images;
    }
};

TEST_F(GeometryForms, AllGiveTheSamePicture)
{
    const auto expected = images();
    for (const Form form :
         {Form::displayList, Form::vertexArrays, Form::buffers, Form::arrayObject, Form::buffers})
        expectSame(*view_, expected, form);
}

TEST_F(GeometryForms, AreArrayObjectsWhereTheDisplaySettingsAskForThem)
{
    const auto expected = images();
    view_.reset();
    osg::DisplaySettings& settings = *osg::DisplaySettings::instance();
    const auto before = settings.getVertexBufferHint();
    settings.setVertexBufferHint(osg::DisplaySettings::VERTEX_ARRAY_OBJECT);
    const auto other = newContext();
    OsgView view(other->loader());
    view.setView(perspectiveView());
    expectSame(view, expected, Form::displayList);
    settings.setVertexBufferHint(before);
}

}  // namespace
}  // namespace fbrdf::test
