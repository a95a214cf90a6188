// AreaLightsTest.h - area lights of the tests of the plain runtime as a node of OpenSceneGraph.
#pragma once
#include <osgFbrdf/AreaLights.h>

namespace fbrdf::test {

inline osg::ref_ptr<osgFbrdf::AreaLights> osgAreaLights(const std::vector<AreaLight>& lights)
{
    osg::ref_ptr<osgFbrdf::AreaLights> node = new osgFbrdf::AreaLights;
    node->setLights(lights);
    return node;
}

}  // namespace fbrdf::test
