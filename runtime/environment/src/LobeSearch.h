// LobeSearch.h - which lobes of the dictionary stand for each theta_o: a greedy start, then one
// lobe at a time is exchanged for the best of the dictionary, held to the lobes of the neighbouring
// knots, between which tables are interpolated.
#pragma once
#include "LobeDictionary.h"
#include "LobeWeights.h"

#include <fbrdf/environment/LobeFit.h>

#include <vector>

namespace fbrdf {

/// f cos at one theta_o in the norm of the dictionary.
struct LobeTarget {
    double theta = 0.0;
    Projected cosine;                   ///< of integral 1
    std::array<Projected, 3> channels;  ///< of f cos theta_i
    Vec3d albedo{0.0};                  ///< their integrals
    double energy = 0.0;                ///< sum of the squares of the channels
    double cosineSquared = 0.0;
    std::array<double, 3> cosineProducts{};           ///< with the channels
    std::vector<double> atomCosine;                   ///< of each atom with the cosine
    std::vector<std::array<double, 3>> atomProducts;  ///< of each atom with the channels
};

/// The target at each angle. Throws Error(fit) where f is not finite.
std::vector<LobeTarget> lobeTargets(const LobeDictionary& dictionary, const Reflectance& f,
                                    const std::vector<double>& thetas, int threads);

/// Atoms of the dictionary, one for each lobe.
using AtomSet = std::vector<size_t>;

struct LobeStart {
    size_t knot = 0;             ///< the search walks outwards from here
    double continuity = 1e-4;    ///< penalty of squared steps in level and tilt between neighbours
    std::vector<AtomSet> fewer;  ///< begins with the lobes of a fit of fewer; may be empty
};

/// One set for each target. At the first, which is normal incidence, all tilts are 0.
std::vector<AtomSet> searchLobes(const LobeDictionary& dictionary,
                                 const std::vector<LobeTarget>& targets, int lobes,
                                 const LobeStart& start);

/// The lobes of one knot: weights that add up to the albedo in each channel, to the last digits of
/// a float.
LobeKnot knotOf(const LobeTarget& target, const std::vector<Projected>& lobes,
                const std::vector<Lobe>& at);

}  // namespace fbrdf
