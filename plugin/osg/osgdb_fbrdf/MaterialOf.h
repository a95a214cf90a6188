// MaterialOf.h - which material an object stands for, when it is written to NAME.fbrdf.
#pragma once
#include <osgFbrdf/MaterialObject.h>

namespace osgFbrdf {

/// The object itself, or the one material of all effects in a scene. Null for none and for several;
/// `problem` then says what was found.
osg::ref_ptr<const MaterialObject> materialOf(const osg::Object& object, std::string& problem);

}  // namespace osgFbrdf
