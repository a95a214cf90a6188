// Reference.h - the pictures of fbrdf::truth under the names of the tests.
#pragma once
#include <fbrdf/truth/Deviation.h>
#include <fbrdf/truth/Reference.h>

#include "Gl.h"
#include "Scenes.h"

namespace fbrdf::test {

using truth::deviationOf;
using truth::GeometryBuffer;
using truth::geometryBuffer;
using truth::referenceImage;
using truth::storedImage;
using truth::SurfaceReference;

}  // namespace fbrdf::test
