#include "EffectCull.h"

#include <osgFbrdf/FactorizedBrdf.h>

#include <osgUtil/CullVisitor>

namespace osgFbrdf {

void cullUnder(const EffectCull& cull, osg::StateSet* state, osg::StateSet* varying)
{
    cull.visitor.pushStateSet(state);
    cull.visitor.pushStateSet(varying);
    cull.cullModel();
    cull.visitor.popStateSet();
    cull.visitor.popStateSet();
}

}  // namespace osgFbrdf
