// PartsTest.h - a model whose parts are told apart by an osg::Material, a state set and a node.
#pragma once
#include "OsgScene.h"

#include "support/gl/Scenes.h"

#include <osg/Material>
#include <osg/MatrixTransform>

#include <array>

namespace fbrdf::test {

/// The names of its first three balls; the fourth is in no part.
inline const std::array<std::string, 3> kPartNames{"paint", "rims", "glass"};
constexpr size_t kBalls = 4;

inline osg::ref_ptr<osg::Material> osgMaterial(const std::string& name)
{
    osg::ref_ptr<osg::Material> material = new osg::Material;
    material->setName(name);
    material->setEmission(osg::Material::FRONT_AND_BACK, {0.25f, 0.5f, 0.75f, 1.0f});
    return material;
}

/// One of four balls beside each other.
inline osg::ref_ptr<osg::MatrixTransform> ball(size_t index)
{
    const double x = index % 2 == 0 ? -0.55 : 0.55, y = index / 2 == 0 ? -0.55 : 0.55;
    osg::ref_ptr<osg::MatrixTransform> ball = new osg::MatrixTransform(
        osg::Matrixd::scale(0.5, 0.5, 0.5) * osg::Matrixd::translate(x, y, 0.0));
    const auto mesh = osgMesh(sphereMesh(12));
    if (index == 0) mesh->getOrCreateStateSet()->setAttribute(osgMaterial("paint"));
    if (index == 1) ball->getOrCreateStateSet()->setName("rims");
    if (index == 2) ball->setName("glass");
    if (index == 3) ball->getOrCreateStateSet()->setAttributeAndModes(osgMaterial("rubber"));
    if (index == 3) ball->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::ON);
    ball->addChild(mesh);
    return ball;
}

inline osg::ref_ptr<osg::Group> fourBalls()
{
    osg::ref_ptr<osg::Group> model = new osg::Group;
    for (size_t i = 0; i < kBalls; ++i) model->addChild(ball(i));
    return model;
}

}  // namespace fbrdf::test
