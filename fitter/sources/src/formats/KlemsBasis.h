// KlemsBasis.h - a hemisphere divided into patches: rings about the normal, each divided evenly in
// azimuth (Klems 1994, "A new method for predicting the solar heat gain of complex fenestration
// systems").
#pragma once
#include "formats/KlemsXml.h"

#include <map>

namespace fbrdf {

class KlemsBasis {
public:
    static constexpr size_t kMostPatches = 4096;

    /// Adds a ring of `phis` patches about the zenith angle `theta`, up to `upper`, in degrees.
    void addRing(double theta, double upper, size_t phis);

    size_t patches() const { return centres_.size(); }
    /// Unit vector through the middle of a patch; patch k of n in a ring is about azimuth 360 k /
    /// n.
    const Vec3d& centre(size_t patch) const { return centres_[patch]; }
    /// The patch that a unit vector above the horizon falls into; the lowest ring beyond it.
    size_t patchOf(const Vec3d& w) const;

private:
    struct Ring {
        double cosUpper = 0.0;       ///< cos of the zenith angle where the ring ends
        size_t phis = 1, first = 0;  ///< patches, and the index of the first
    };
    std::vector<Ring> rings_;
    std::vector<Vec3d> centres_;
};

/// Bases by name, lower case: those that Radiance knows ("LBNL/Klems Full" with 145 patches, "Half"
/// with 73, "Quarter" with 41), and those that the file defines, which go before. Throws
/// Error(input) for rings that are none.
std::map<std::string, KlemsBasis> klemsBases(const InputFile& file, const pugi::xml_node& root);

}  // namespace fbrdf
