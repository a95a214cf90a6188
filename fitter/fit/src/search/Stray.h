// Stray.h - the values that a fit invents between and beyond the samples.
#pragma once
#include <fbrdf/brdf/Material.h>
#include <fbrdf/sources/Source.h>

#include <vector>

namespace fbrdf {

/// What a fit may be at directions spread over all pairs: of a hue that the nearest samples have,
/// and not much brighter than they are. A sum of terms on few samples can follow each of them and
/// be green, or a white rim, in between, where no error on samples sees it, yet anyone does who
/// looks at a picture.
class Stray {
public:
    /// `isotropic`: samples count as turned about the normal; without it brightness is free. A
    /// channel at or below `floor` may be anything below.
    Stray(const std::vector<Sample>& samples, const Vec3f& floor, bool isotropic, int threads);

    /// How far a material leaves the ranges of the nearest samples: means of natural logarithms
    /// over the pairs, weighted by the cube root of the radiance that they reflect. 0: it invents
    /// nothing.
    struct Mean {
        double hue = 0;         ///< of its channels relative to the brightest
        double brightness = 0;  ///< of the brightest
    };
    Mean of(const Material& material, int threads) const;

    /// Samples that draw a fit back into the ranges: at the pairs where `material` leaves them, the
    /// values within that are nearest to its own.
    std::vector<Sample> restraints(const Material& material, int threads) const;

private:
    struct Range {
        Vec3f lower, upper;  ///< of ln(f_c / max f)
        float brightest;     ///< the largest ln(max f)
    };
    struct Way {
        float hue, brightness;
    };
    static Way wayOut(const Range& range, const Vec3f& value);
    static Vec3f nearestWithin(const Range& range, const Vec3f& value);

    std::vector<Sample> probes_;  ///< directions alone
    std::vector<Range> ranges_;
};

}  // namespace fbrdf
