#include "GlObjectsInUse.h"

#include "Surfaces.h"

#include <OpenThreads/ScopedLock>

#include <algorithm>

namespace osgFbrdf {
namespace {

using Lock = OpenThreads::ScopedLock<OpenThreads::Mutex>;

}  // namespace

void GlObjectsInUse::use(Surfaces& surfaces)
{
    const Lock lock(mutex_);
    if (std::find(surfaces_.begin(), surfaces_.end(), &surfaces) != surfaces_.end()) return;
    surfaces_.erase(std::remove_if(surfaces_.begin(), surfaces_.end(),
                                   [](const auto& known) { return !known.valid(); }),
                    surfaces_.end());
    surfaces_.emplace_back(&surfaces);
}

void GlObjectsInUse::release(osg::State* state)
{
    const Lock lock(mutex_);
    for (const auto& known : surfaces_) {
        osg::ref_ptr<Surfaces> surfaces;
        if (known.lock(surfaces)) surfaces->releaseGLObjects(state);
    }
    ++releases_;
}

bool GlObjectsInUse::arraysReleased(unsigned int contextId) const
{
    const Lock lock(mutex_);
    const auto known = forgotten_.find(contextId);
    return releases_ != (known == forgotten_.end() ? 0 : known->second);
}

void GlObjectsInUse::arraysForgotten(unsigned int contextId)
{
    const Lock lock(mutex_);
    forgotten_[contextId] = releases_;
}

}  // namespace osgFbrdf
