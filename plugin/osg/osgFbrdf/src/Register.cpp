// The one static that OSG needs: by it osgFX::Registry, and so osgfxbrowser, finds the effect.
#include <osgFbrdf/FactorizedBrdf.h>

#include <osgFX/Registry>

namespace {
const osgFX::Registry::Proxy proxy(new osgFbrdf::FactorizedBrdf);
}
