// PartsModel.h - a model of parts with names, for materials of their own.
#pragma once
#include <osg/Geometry>
#include <osg/Group>

/// The knot ("knot") above a chequered plate ("plate") with two balls ("ball left", "ball right").
/// The plate has its colours in texture unit 0.
osg::ref_ptr<osg::Group> partsModel(osg::Geometry* knot);
