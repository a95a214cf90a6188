#include "LibraryResources.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/shaders/PackedParameters.h>

#include <algorithm>

namespace fbrdf::gl {
namespace {

void checkMaterial(const Material& material, size_t index)
{
    validate(material, "material " + std::to_string(index) + " of a library");
    validate(material.lobes, "material " + std::to_string(index) + " of a library");
}

Material layoutOf(const Material& material)
{
    Material layout{material.form, {}, material.scales, material.name, {}, {}, material.lobes};
    for (const Table& table : material.tables) {
        layout.tables.emplace_back();
        layout.tables.back().storage = table.storage;
    }
    return layout;
}

}  // namespace

LibraryResources::LibraryResources(DevicePtr device, const std::vector<Material>& materials,
                                   const MaterialOptions& options, const Check& check)
    : device_(std::move(device)), options_(options), places_(materials.size())
{
    std::vector<std::vector<const Material*>> members;
    for (size_t i = 0; i < materials.size(); ++i) {
        checkMaterial(materials[i], i);
        const size_t room = capacity(materials[i]);
        const auto fits = [&](const std::vector<const Material*>& group) {
            return group.size() < room && sameLayout(*group.front(), materials[i]);
        };
        const auto group = std::find_if(members.begin(), members.end(), fits);
        places_[i].group = static_cast<size_t>(group - members.begin());
        if (group == members.end()) members.emplace_back();
        places_[i].layer = members[places_[i].group].size();
        members[places_[i].group].push_back(&materials[i]);
    }
    // Groups are made when their members are known: arrays cannot grow.
    for (const auto& group : members) groups_.push_back(made(group, check));
}

/// Why a material of the form must be alone in its group; empty where it need not.
std::string LibraryResources::whyNotPacked(const Form& form) const
{
    if (options_.lookUp != LookUp::native)
        return Found(std::string(lookUpName(options_.lookUp)) + " maps asked for")
            .expected("native ones: only those have one size");
    return fbrdf::whyNotPacked(form, device_->capabilities);
}

/// The number of materials of the layout that fit into one group.
size_t LibraryResources::capacity(const Material& material) const
{
    if (!whyNotPacked(material.form).empty()) return 1;
    const int texels = std::max(parameterLayout(material.form).stride,
                                packedLobeStride(fbrdf::layoutOf(material.lobes)));
    return static_cast<size_t>(std::min(device_->capabilities.maxArrayLayers,
                                        device_->capabilities.maxBufferTexels / texels));
}

LibraryResources::Group LibraryResources::made(const std::vector<const Material*>& members,
                                               const Check& check)
{
    const Material& first = *members.front();
    const std::string why = whyNotPacked(first.form);
    if (whyNotPacked_.empty()) whyNotPacked_ = why;
    Group group{layoutOf(first), nullptr, members.size()};
    group.gpu = why.empty()
                    ? std::make_unique<MaterialResources>(device_, members, options_.precise)
                    : std::make_unique<MaterialResources>(device_, first, options_);
    // Throws while nothing refers to the group yet.
    check(*group.gpu);
    return group;
}

void LibraryResources::replace(size_t index, const Material& material, const Check& check)
{
    FBRDF_ASSERT(index, <, places_.size());
    checkMaterial(material, index);
    Place& place = places_[index];
    Group& group = groups_[place.group];
    // The common case, an edited material, uploads one layer and compiles nothing.
    if (group.gpu->isPacked() && sameLayout(group.layout, material))
        return group.gpu->replaceLayer(place.layer, material);
    // Made before the old one goes, so that a failure leaves the library as it was.
    Group replacement = made({&material}, check);
    if (group.members == 1) {
        group = std::move(replacement);
    } else {
        --group.members;
        groups_.push_back(std::move(replacement));
        place.group = groups_.size() - 1;
    }
    place.layer = 0;
}

}  // namespace fbrdf::gl
