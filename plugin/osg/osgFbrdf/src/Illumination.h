// Illumination.h - what lights one object, in eye coordinates, and the shadows that fall on it.
#pragma once
#include "EyeLights.h"
#include "EyeLobes.h"
#include "LightLists.h"
#include "ShadowHook.h"

namespace osgFbrdf {

struct Illumination {
    fbrdf::Sphere bounds;                  ///< of the object
    EyeLights lights;                      ///< empty but for attenuations where there are lists
    osg::ref_ptr<const LightLists> lists;  ///< of all lights of the view; null: there are none
    EyeLobes lobes;
    ReceivedShadows shadows;

    /// Lights for which passes are planned: of lists, one stands for all.
    int planned() const { return lists ? 1 : static_cast<int>(lights.lights.size()); }
    LightHooks hooks() const
    {
        return {!lights.attenuations.empty(), lights.lights.empty() ? ShadowMaps() : shadows.maps};
    }
};

}  // namespace osgFbrdf
