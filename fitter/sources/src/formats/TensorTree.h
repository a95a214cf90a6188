// TensorTree.h - Radiance's variable-resolution BSDF: a tree of values over a cube of 3 or 4
// coordinates (Ward, Kurt, Bonneel 2012, "A Practical Framework for Sharing and Rendering
// Real-World Bidirectional Scattering Distribution Functions"; genBSDF's options -t3 and -t4).
// Text: "{ v v .. }" is a grid of 2^(rank k) values for some k, first coordinate slowest; "{ {..}
// {..} .. }" divides the cube in two along each coordinate, branch n in the upper half of
// coordinate i where bit i of n is set. Values in 1/sr, without the cosine. Coordinates, of unit
// vectors that point away from the surface: rank 4 has those of -wi and then those of wo, each
// projected on the disc and mapped to the square of Shirley and Chiu 1997; rank 3, for isotropic
// surfaces, has 1/2 - |wi projected| / 2, and then those of wo turned so that -wi lies at azimuth
// 0.
#pragma once
#include "InputFile.h"

#include <fbrdf/brdf/Conventions.h>

#include <array>
#include <string_view>
#include <vector>

namespace fbrdf {

class TensorTree {
public:
    /// `rank` is 3 or 4. Throws Error(input) for text that is no such tree.
    TensorTree(const InputFile& file, std::string_view text, int rank);

    /// f of unit vectors above the horizon.
    double operator()(const Vec3d& wo, const Vec3d& wi) const;
    /// Number of values in all.
    size_t size() const { return values_.size(); }
    /// Mean of the values, each weighted by its share of the cube.
    double mean() const;

private:
    class Parser;
    using Point = std::array<double, 4>;
    struct Node {
        int32_t log2Grid = -1;  ///< below 0 for branches
        uint32_t first = 0;     ///< index of the first child in children_, or of the first value
    };

    double lookUp(Point at) const;
    double meanOf(const Node& node) const;

    int rank_;
    std::vector<Node> nodes_;
    std::vector<uint32_t> children_;  ///< indices of nodes, 2^rank for each branch
    std::vector<float> values_;
};

}  // namespace fbrdf
