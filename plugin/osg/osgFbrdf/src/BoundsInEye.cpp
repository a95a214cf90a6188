#include "BoundsInEye.h"

#include "Vectors.h"

#include <algorithm>
#include <cmath>

namespace osgFbrdf {
namespace {

/// How much longer a matrix can make a vector, at most: the square root of the largest row sum of
/// M M^T, exact where rows are at right angles.
double largestScale(const osg::Matrixd& matrix)
{
    const auto row = [&](int i) { return osg::Vec3d(matrix(i, 0), matrix(i, 1), matrix(i, 2)); };
    double largest = 0.0;
    for (int i = 0; i < 3; ++i)
        largest = std::max(largest, std::abs(row(i) * row(0)) + std::abs(row(i) * row(1)) +
                                        std::abs(row(i) * row(2)));
    return std::sqrt(largest);
}

}  // namespace

fbrdf::Sphere boundsInEye(const osg::Node& model, const osg::Matrixd& toEye)
{
    const osg::BoundingSphere& bound = model.getBound();
    const osg::Vec3d centre = osg::Vec3d(bound.center()) * toEye;
    const double radius = std::max(0.0, static_cast<double>(bound.radius()));
    return {toVec3(centre), static_cast<float>(largestScale(toEye) * radius)};
}

}  // namespace osgFbrdf
