// osgFX::Registry, and so osgfxbrowser, finds the effect by this static object.
#include <osgFbrdf/FactorizedBrdf.h>

#include <osgFX/Registry>

namespace {
const osgFX::Registry::Proxy proxy(new osgFbrdf::FactorizedBrdf);
}
