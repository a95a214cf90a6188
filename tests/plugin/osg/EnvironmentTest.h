// EnvironmentTest.h - environments of the tests of the plain runtime as nodes of OpenSceneGraph.
#pragma once
#include <fbrdf/environment/Panorama.h>

#include <osgFbrdf/EnvironmentLight.h>

#include <osg/MatrixTransform>

namespace fbrdf::test {

constexpr int kFaceSize = 32;

/// With faces of kFaceSize texels, so that it takes a moment only.
inline osg::ref_ptr<osgFbrdf::EnvironmentLight> osgEnvironment(const Panorama& panorama)
{
    osg::ref_ptr<osgFbrdf::EnvironmentLight> environment = new osgFbrdf::EnvironmentLight;
    environment->setFaceSize(kFaceSize);
    environment->setPanorama(panorama);
    return environment;
}

/// The node under a transform by which its up, +z, becomes +y, as in the runtime's scenes.
inline osg::ref_ptr<osg::MatrixTransform> uprightFor(osg::Node* node)
{
    osg::ref_ptr<osg::MatrixTransform> upright =
        new osg::MatrixTransform(osg::Matrixd::rotate(-0.5 * osg::PI, 1.0, 0.0, 0.0));
    upright->addChild(node);
    return upright;
}

}  // namespace fbrdf::test
