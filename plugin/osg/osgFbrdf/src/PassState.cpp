#include "PassState.h"

#include <osg/Depth>

namespace osgFbrdf {

void setBin(osg::StateSet& state, int number)
{
    state.setRenderBinDetails(number, "RenderBin",
                              osg::StateSet::OVERRIDE_PROTECTED_RENDERBIN_DETAILS);
}

void setPlace(osg::StateSet& state, fbrdf::Depth depth, int bin)
{
    const bool writes = depth == fbrdf::Depth::write;
    state.setAttributeAndModes(
        new osg::Depth(writes ? osg::Depth::LESS : osg::Depth::EQUAL, 0.0, 1.0, writes), kOurs);
    state.setMode(GL_ALPHA_TEST, kOff);
    setBin(state, bin);
}

}  // namespace osgFbrdf
