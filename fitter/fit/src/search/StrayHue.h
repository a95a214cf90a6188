// StrayHue.h - the hues that a fit invents between and beyond the samples.
#pragma once
#include <fbrdf/brdf/Material.h>
#include <fbrdf/sources/Source.h>

#include <vector>

namespace fbrdf {

/// The hues that a fit may have at directions spread over all pairs: those of the nearest samples.
/// A sum of terms on few samples can follow each of them and be green or yellow in between, where
/// no error on samples sees it, yet anyone does who looks at a picture.
class StrayHue {
public:
    /// `isotropic`: samples count as turned about the normal. A channel at or below `floor` may be
    /// anything below.
    StrayHue(const std::vector<Sample>& samples, const Vec3f& floor, bool isotropic, int threads);

    /// By how much the channels of the material, relative to the brightest, leave the range of
    /// those of the nearest samples: a mean of natural logarithms over the pairs, weighted by the
    /// cube root of the radiance that they reflect. 0: it has no hue that its neighbours have not.
    double of(const Material& material, int threads) const;

private:
    struct Range {
        Vec3f lower, upper;  ///< of ln(f_c / max f)
    };
    std::vector<Sample> probes_;  ///< directions alone
    std::vector<Range> ranges_;
};

}  // namespace fbrdf
