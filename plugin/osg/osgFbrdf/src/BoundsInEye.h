// BoundsInEye.h - the bounds of a model as lights and lists see them.
#pragma once
#include <fbrdf/plan/LightSelection.h>

#include <osg/Matrixd>
#include <osg/Node>

namespace osgFbrdf {

/// Of the model, in eye coordinates; toEye may scale by different factors along its axes.
fbrdf::Sphere boundsInEye(const osg::Node& model, const osg::Matrixd& toEye);

}  // namespace osgFbrdf
