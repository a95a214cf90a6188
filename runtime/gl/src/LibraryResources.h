// LibraryResources.h - many materials: those of one layout share texture arrays, a program and a
// draw.
#pragma once
#include "MaterialResources.h"

#include <functional>

namespace fbrdf::gl {

class LibraryResources {
public:
    /// Called for each group before anything refers to it; throws where GL cannot draw it.
    using Check = std::function<void(const MaterialResources&)>;

    /// Throws Error(input) for an invalid material, naming its index, Error(gl) where GL cannot
    /// store them.
    LibraryResources(DevicePtr device, const std::vector<Material>& materials,
                     const MaterialOptions& options, const Check& check);

    void replace(size_t index, const Material& material, const Check& check);

    /// The group of a material and its layer in the group's arrays; 0 in a group of one.
    struct Place {
        size_t group = 0;
        size_t layer = 0;
    };
    const Device* device() const { return device_.get(); }
    const std::vector<Place>& places() const { return places_; }
    size_t groupCount() const { return groups_.size(); }
    const MaterialResources& group(size_t index) const { return *groups_[index].gpu; }
    const std::string& whyNotPacked() const { return whyNotPacked_; }  ///< see Handles.h

private:
    struct Group {
        Material layout;  ///< the group's first material without its texels
        std::unique_ptr<MaterialResources> gpu;
        size_t members = 0;
    };
    Group made(const std::vector<const Material*>& members, const Check& check);
    std::string whyNotPacked(const Form& form) const;
    size_t capacity(const Material& material) const;

    DevicePtr device_;
    MaterialOptions options_;
    std::vector<Group> groups_;
    std::vector<Place> places_;  ///< of each material
    std::string whyNotPacked_;
};

}  // namespace fbrdf::gl
