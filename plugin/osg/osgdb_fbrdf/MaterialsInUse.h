// MaterialsInUse.h - the materials that were read from files and are still in use, so that what
// names a file again gets the same object: effects that share it share textures and programs.
#pragma once
#include <osgFbrdf/MaterialObject.h>

#include <osg/observer_ptr>

#include <OpenThreads/Mutex>

#include <cstdint>
#include <map>
#include <string>
#include <tuple>

namespace osgFbrdf {

/// Thread-safe. It keeps no material alive.
class MaterialsInUse {
public:
    /// Name, then what differs from one content of the file to the next: device, file number, size,
    /// and the times of the last write and of the last change of the file's attributes.
    using Key = std::tuple<std::string, uint64_t, uint64_t, int64_t, int64_t, int64_t>;
    /// name: the one that the material is to have; path: where the file is now.
    static Key keyOf(const std::string& name, const std::string& path);

    /// Null where none is in use.
    osg::ref_ptr<MaterialObject> find(const Key& key) const;
    void add(const Key& key, MaterialObject& material);

private:
    mutable OpenThreads::Mutex mutex_;
    std::map<Key, osg::observer_ptr<MaterialObject>> materials_;
};

}  // namespace osgFbrdf
