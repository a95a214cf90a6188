#include "Sphere.h"

#include <osgFbrdf/FactorizedBrdf.h>

#include <cmath>

namespace osgFbrdf {
namespace {

constexpr unsigned int kRings = 48, kColumns = 96;

}  // namespace

osg::ref_ptr<osg::Geometry> unitSphere()
{
    osg::ref_ptr<osg::Vec3Array> positions = new osg::Vec3Array, tangents = new osg::Vec3Array;
    for (unsigned int i = 0; i <= kRings; ++i)
        for (unsigned int j = 0; j <= kColumns; ++j) {
            const double theta = osg::PI * i / kRings, phi = 2.0 * osg::PI * j / kColumns;
            positions->push_back({static_cast<float>(std::sin(theta) * std::cos(phi)),
                                  static_cast<float>(std::sin(theta) * std::sin(phi)),
                                  static_cast<float>(std::cos(theta))});
            tangents->push_back(
                {static_cast<float>(-std::sin(phi)), static_cast<float>(std::cos(phi)), 0.0f});
        }
    osg::ref_ptr<osg::DrawElementsUInt> triangles = new osg::DrawElementsUInt(GL_TRIANGLES);
    for (unsigned int i = 0; i < kRings; ++i)
        for (unsigned int j = 0; j < kColumns; ++j) {
            const unsigned int a = i * (kColumns + 1) + j, b = a + kColumns + 1;
            for (const unsigned int index : {a, b, b + 1, a, b + 1, a + 1})
                triangles->push_back(index);
        }
    osg::ref_ptr<osg::Geometry> sphere = new osg::Geometry;
    sphere->setUseVertexBufferObjects(true);
    sphere->setVertexArray(positions);
    sphere->setNormalArray(positions, osg::Array::BIND_PER_VERTEX);
    sphere->setVertexAttribArray(kTangentAttribute, tangents, osg::Array::BIND_PER_VERTEX);
    sphere->addPrimitiveSet(triangles);
    return sphere;
}

}  // namespace osgFbrdf
