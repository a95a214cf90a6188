// PlainParts.h - the parts of a model in the plain form of a scene (osgFbrdf/PlainForm.h): each has
// an osg::Material of its own, and its own state set beside it to be restored.
#pragma once
#include <osg/Material>
#include <osg/Node>

namespace osgFbrdf {

class FactorizedBrdf;

/// A diffuse surface as bright as the material of the effect. ambient: it reflects ambient light
/// too, which then stands for an environment.
osg::ref_ptr<osg::Material> plainMaterial(const FactorizedBrdf& effect, bool ambient);

/// Gives the parts below an effect their osg::Materials. The nodes below are a copy of the scene's;
/// drawables are copied where they are parts.
void paintParts(FactorizedBrdf& effect, bool ambient);

/// True for a node that paintParts() has changed.
bool isPainted(const osg::Node& node);
void restorePaintedPart(osg::Node& node);

}  // namespace osgFbrdf
