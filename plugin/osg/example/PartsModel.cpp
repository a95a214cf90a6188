#include "PartsModel.h"

#include <osg/ShapeDrawable>
#include <osg/Texture2D>

#include <string>

namespace {

constexpr float kPlate = -1.75f, kBall = 0.42f;  // height of its upper side; radius
constexpr int kFields = 8;                       // of the chequer, along each side

osg::ref_ptr<osg::Texture2D> chequer()
{
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(kFields, kFields, 1, GL_RGB, GL_UNSIGNED_BYTE);
    for (int y = 0; y < kFields; ++y)
        for (int x = 0; x < kFields; ++x) {
            const bool isDark = (x + y) % 2 == 0;
            unsigned char* texel = image->data(x, y);
            texel[0] = isDark ? 60 : 235;
            texel[1] = isDark ? 90 : 230;
            texel[2] = isDark ? 120 : 220;
        }
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    return texture;
}

osg::ref_ptr<osg::Geometry> plate()
{
    osg::ref_ptr<osg::Geometry> plate = osg::createTexturedQuadGeometry(
        {-2.4f, -2.0f, kPlate}, {4.8f, 0.0f, 0.0f}, {0.0f, 4.4f, 0.0f});
    plate->setName("plate");
    plate->getOrCreateStateSet()->setTextureAttributeAndModes(0, chequer());
    return plate;
}

osg::ref_ptr<osg::ShapeDrawable> ball(const std::string& name, float x)
{
    const osg::ref_ptr<osg::TessellationHints> fine = new osg::TessellationHints;
    fine->setDetailRatio(2.0f);
    osg::ref_ptr<osg::ShapeDrawable> ball =
        new osg::ShapeDrawable(new osg::Sphere({x, -1.15f, kPlate + kBall}, kBall), fine);
    ball->setName(name);
    return ball;
}

}  // namespace

osg::ref_ptr<osg::Group> partsModel(osg::Geometry* knot)
{
    knot->setName("knot");
    osg::ref_ptr<osg::Group> model = new osg::Group;
    model->addChild(knot);
    model->addChild(plate());
    model->addChild(ball("ball left", -1.25f));
    model->addChild(ball("ball right", 1.25f));
    return model;
}
