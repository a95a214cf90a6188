// In targets that OpenGL encodes as sRGB, linear output equals what the sRGB curve writes to plain
// ones, surfaces stay linear, and objects beside an effect keep their codes.
#include "EffectTest.h"

#include "support/gl/Scenes.h"

#include <osg/MatrixTransform>
#include <osg/Shape>
#include <osg/ShapeDrawable>

#include <cstdlib>

// OpenGL 3.0 defines these, and headers of OpenGL 2 lack them.
#ifndef GL_FRAMEBUFFER_SRGB
#define GL_FRAMEBUFFER_SRGB 0x8DB9
#endif
#ifndef GL_SRGB8_ALPHA8
#define GL_SRGB8_ALPHA8 0x8C43
#endif

namespace fbrdf::test {
namespace {

using Codes = std::vector<int>;  ///< RGBA, rows from the bottom

struct Way {
    const char* name;
    size_t material;
    int technique;
};

class Srgb : public EffectTest, public ::testing::WithParamInterface<Way> {
protected:
    /// The codes that a camera stores in a target of that format.
    Codes codesOf(osg::Node* scene, GLint format)
    {
        const osg::ref_ptr<osg::Image> image = new osg::Image;
        image->allocateImage(kSize, kSize, 1, GL_RGBA, GL_UNSIGNED_BYTE);
        image->setInternalTextureFormat(format);
        const osg::ref_ptr<osg::Camera> camera = new osg::Camera;
        camera->setRenderOrder(osg::Camera::PRE_RENDER);
        camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
        camera->attach(osg::Camera::COLOR_BUFFER0, image);
        camera->setViewport(0, 0, kSize, kSize);
        camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
        camera->setViewMatrix(osgMatrix(perspectiveView().view));
        camera->setProjectionMatrix(osgMatrix(perspectiveView().projection));
        camera->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
        camera->setClearColor({0.0f, 0.0f, 0.0f, 0.0f});
        if (format == GL_SRGB8_ALPHA8)
            camera->getOrCreateStateSet()->setMode(GL_FRAMEBUFFER_SRGB, osg::StateAttribute::ON);
        camera->addChild(scene);
        view_->setScene(camera);
        view_->viewer().setLightingMode(osg::View::HEADLIGHT);
        view_->frame();
        view_->frame();
        return {image->data(), image->data() + image->getTotalSizeInBytes()};
    }
};

/// The pixels of an image: all of them, or those alone that another image does not have.
int furthest(const Codes& a, const Codes& b, const Codes& mask, bool inMask)
{
    int worst = 0;
    for (size_t i = 0; i < a.size(); ++i)
        if ((mask[i - i % 4 + 3] > 0) == inMask) worst = std::max(worst, std::abs(a[i] - b[i]));
    return worst;
}

TEST_P(Srgb, TargetsStoreWhatTheCurveStoresInOthers)
{
    const auto effect = osgEffect(testMaterials()[GetParam().material], sphereMesh(24));
    effect->setFloatTarget(false);
    effect->setExposure(0.05f);
    effect->selectTechnique(GetParam().technique);
    effect->addChild(osgLights(testLights(9)));
    const osg::ref_ptr<osg::MatrixTransform> aside =
        new osg::MatrixTransform(osg::Matrixd::translate(1.1, 0.6, -1.0));
    aside->addChild(new osg::ShapeDrawable(new osg::Sphere({}, 0.7f)));
    const osg::ref_ptr<osg::Group> both = new osg::Group;
    both->addChild(aside);
    const Codes plainAside = codesOf(both, GL_RGBA8), encodedAside = codesOf(both, GL_SRGB8_ALPHA8);
    EXPECT_GT(furthest(plainAside, encodedAside, plainAside, true), 20);
    const Codes mask = codesOf(effect, GL_RGBA8);
    both->addChild(effect);

    const Codes encoded = codesOf(both, GL_SRGB8_ALPHA8);
    const Codes unencoded = codesOf(both, GL_RGBA8);
    effect->setTransfer(Transfer::srgb);
    const Codes curved = codesOf(both, GL_RGBA8);
    EXPECT_LE(furthest(encoded, curved, mask, true), 1);
    EXPECT_GT(furthest(encoded, unencoded, mask, true), 20);
    EXPECT_EQ(furthest(encoded, encodedAside, mask, false), 0);
    EXPECT_EQ(furthest(curved, plainAside, mask, false), 0);
    EXPECT_EQ(effect->lastReport().reason, "");
}

INSTANTIATE_TEST_SUITE_P(Ways, Srgb,
                         ::testing::Values(Way{"SinglePass", 0, osgFbrdf::kSinglePass},
                                           Way{"TwoLookupsInSurfaces", 0, osgFbrdf::kTwoLookups},
                                           Way{"SumInSurfaces", 4, osgFbrdf::kTwoLookups}),
                         [](const ::testing::TestParamInfo<Way>& way) {
                             return std::string(way.param.name);
                         });

}  // namespace
}  // namespace fbrdf::test
