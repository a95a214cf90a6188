#include "MaterialsInUse.h"

#include <OpenThreads/ScopedLock>

#include <sys/stat.h>

namespace osgFbrdf {
namespace {

using Lock = OpenThreads::ScopedLock<OpenThreads::Mutex>;

int64_t nanoseconds(const timespec& time)
{
    return int64_t{time.tv_sec} * 1000000000 + time.tv_nsec;
}

}  // namespace

MaterialsInUse::Key MaterialsInUse::keyOf(const std::string& name, const std::string& path)
{
    struct stat status {};
    // A file that is not there is refused when it is read; until then it is one without a size.
    if (stat(path.c_str(), &status) != 0) status = {};
    return {name,
            status.st_dev,
            status.st_ino,
            status.st_size,
            nanoseconds(status.st_mtim),
            nanoseconds(status.st_ctim)};
}

osg::ref_ptr<MaterialObject> MaterialsInUse::find(const Key& key) const
{
    const Lock lock(mutex_);
    osg::ref_ptr<MaterialObject> material;
    const auto known = materials_.find(key);
    if (known != materials_.end()) known->second.lock(material);
    return material;
}

void MaterialsInUse::add(const Key& key, MaterialObject& material)
{
    const Lock lock(mutex_);
    for (auto known = materials_.begin(); known != materials_.end();)
        known = known->second.valid() ? std::next(known) : materials_.erase(known);
    materials_[key] = &material;
}

}  // namespace osgFbrdf
