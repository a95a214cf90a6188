// MaterialOf.h - finds the material of an object that is written to NAME.fbrdf.
#pragma once
#include <osgFbrdf/MaterialObject.h>

namespace osgFbrdf {

/// The object itself, or the one material of all effects in a scene. Null where there is none and
/// where there are several; `problem` then names what was found.
osg::ref_ptr<const MaterialObject> materialOf(const osg::Object& object, std::string& problem);

}  // namespace osgFbrdf
