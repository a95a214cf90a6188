// ShadowScene.h - a ball over a floor, and lamps that throw its shadow there.
#pragma once
#include "EffectTest.h"

#include "support/gl/Scenes.h"

#include <osg/LightSource>
#include <osg/MatrixTransform>
#include <osgShadow/ShadowTechnique>

#include <memory>
#include <vector>

namespace fbrdf::test {

using Picture = std::vector<float>;

inline const glm::dvec3 kBall(0.1, 0.2, -0.2);
constexpr double kBallRadius = 0.4, kFloor = -1.3, kHalf = 2.5;

inline gl::MeshData floorMesh()
{
    const auto half = static_cast<float>(kHalf), z = static_cast<float>(kFloor);
    gl::MeshData mesh;
    mesh.positions = {{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}};
    mesh.normals.assign(4, {0.0f, 0.0f, 1.0f});
    mesh.tangents.assign(4, {1.0f, 0.0f, 0.0f});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

inline osg::ref_ptr<osg::Node> ballOverFloor()
{
    osg::ref_ptr<osg::MatrixTransform> ball =
        new osg::MatrixTransform(osg::Matrixd::scale(kBallRadius, kBallRadius, kBallRadius) *
                                 osg::Matrixd::translate(kBall.x, kBall.y, kBall.z));
    ball->addChild(osgMesh(sphereMesh(24)));
    return ball;
}

/// Without ambient light.
inline osg::ref_ptr<osg::Light> osgLight(int number, const osg::Vec4f& position)
{
    osg::ref_ptr<osg::Light> light = new osg::Light(static_cast<unsigned int>(number));
    light->setPosition(position);
    light->setAmbient({0.0f, 0.0f, 0.0f, 1.0f});
    light->setDiffuse({1.0f, 0.8f, 0.6f, 1.0f});
    return light;
}

inline osg::ref_ptr<osg::LightSource> sourceOf(osg::Light* light)
{
    osg::ref_ptr<osg::LightSource> source = new osg::LightSource;
    source->setLight(light);
    return source;
}

/// A view of a floor of the effect.
class FloorTest : public EffectTest {
protected:
    void SetUp() override
    {
        EffectTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        view_ = std::make_unique<OsgView>(context().loader());
        view_->setView(perspectiveView());
        effect_ = osgEffect(testMaterials()[0], floorMesh());
    }
    // osg::Identifier deadlocks where a cull visitor is deleted after the technique that knew it.
    void TearDown() override
    {
        EffectTest::TearDown();
        techniques_.clear();
    }

    osg::ref_ptr<osgFbrdf::FactorizedBrdf> effect_;
    std::vector<osg::ref_ptr<osgShadow::ShadowTechnique>> techniques_;
};

}  // namespace fbrdf::test
