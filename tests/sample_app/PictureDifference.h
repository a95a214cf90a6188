// PictureDifference.h - how far a picture is from its reference, in the terms that the tests state.
#pragma once
#include <fbrdf/scene/Image.h>

namespace fbrdf::scene {

/// Relative differences are |a - b| / max(|b|, floor), per channel, with
///     floor = kFloorShare x the largest value of the reference.
/// A thousandth of the brightest pixel is where the shading of grazing directions ends: there a
/// float cosine has lost most of its digits, and no exposure that shows the highlight shows it.
constexpr double kFloorShare = 1e-3;

struct PictureDifference {
    int compared = 0;         ///< pixels that both cover
    int coverageDiffers = 0;  ///< pixels that one covers: left out of worst
    bool edgesOnly = true;    ///< each of them has a neighbour that the reference covers otherwise
    double worst = 0.0;       ///< relative, over the compared pixels
    double mean = 0.0;        ///< relative, likewise
    int worstX = 0, worstY = 0;
};

/// Expects pictures of one size.
PictureDifference compare(const Image& picture, const Image& reference);

}  // namespace fbrdf::scene
