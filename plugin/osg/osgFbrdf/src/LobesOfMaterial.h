// LobesOfMaterial.h - how a material reflects environments. Files from before there were lobes have
// none: theirs are fitted by a thread when they are first wanted.
#pragma once
#include <fbrdf/brdf/Material.h>

#include <OpenThreads/Mutex>

#include <future>
#include <map>
#include <memory>
#include <string>

namespace osgFbrdf {

/// Thread-safe. The destructor waits for a fit that has begun.
class LobesOfMaterial {
public:
    using Table = std::shared_ptr<const fbrdf::LobeTable>;

    /// Keeps a copy of a material without lobes until they are fitted.
    explicit LobesOfMaterial(const fbrdf::Material& material);

    /// The lobes, at most `most` of them (0: all), always the same object; null, with the reason,
    /// where there are none yet.
    Table find(int most, std::string& whyNot);

private:
    void begin();
    void finish();

    OpenThreads::Mutex mutex_;
    Table all_;                   ///< null: none yet
    std::map<int, Table> fewer_;  ///< by the number asked for
    std::shared_ptr<const fbrdf::Material> unfitted_;
    std::future<Table> fit_;
    std::string failure_;
};

}  // namespace osgFbrdf
