#include "formats/KlemsBasis.h"

#include "SampleRow.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/base/Number.h>
#include <fbrdf/base/Text.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

/// Where a ring starts, in degrees, and its patches.
struct RingStart {
    double lower;
    size_t phis;
};

/// Definitions of the bases that files may name without defining them. The first ring is a cap.
const std::map<std::string, std::vector<RingStart>> kKnownBases = {
    {"lbnl/klems full",
     {{0, 1}, {5, 8}, {15, 16}, {25, 20}, {35, 24}, {45, 24}, {55, 24}, {65, 16}, {75, 12}}},
    {"lbnl/klems half",
     {{0, 1}, {6.5, 8}, {19.5, 12}, {32.5, 16}, {46.5, 20}, {61.5, 12}, {76.5, 4}}},
    {"lbnl/klems quarter", {{0, 1}, {9, 8}, {27, 12}, {46, 12}, {66, 8}}},
};

KlemsBasis basisFrom(const std::vector<RingStart>& rings)
{
    KlemsBasis basis;
    for (size_t i = 0; i < rings.size(); ++i) {
        const double upper = i + 1 < rings.size() ? rings[i + 1].lower : 90.0;
        const double theta = i == 0 ? 0.0 : 0.5 * (rings[i].lower + upper);
        basis.addRing(theta, upper, rings[i].phis);
    }
    return basis;
}

/// Adds the ring of an AngleBasisBlock, which must begin at `end`, where the one before ends, or
/// later.
void addBlock(const InputFile& file, const pugi::xml_node& block, KlemsBasis& basis, double& end)
{
    const double phis = numberIn(file, block, "nPhis");
    const pugi::xml_node bounds = childNamed(block, "ThetaBounds");
    const double lower = numberIn(file, bounds, "LowerTheta"),
                 upper = numberIn(file, bounds, "UpperTheta");
    if (!(phis >= 1.0 && phis <= 360.0) || phis != std::floor(phis) || !(lower >= 0.0) ||
        !(upper > lower && upper <= 90.0))
        throw inputError(
            file, Found("a ring of " + numberText(phis, 12) + " patches from " + numberText(lower) +
                        " to " + numberText(upper) + " degrees")
                      .expected("1 to 360 patches and ascending angles within [0, 90]"));
    if (lower < end)
        throw inputError(file, Found("rings that overlap").expected("ascending angles"));
    if (basis.patches() + size_t(phis) > KlemsBasis::kMostPatches)
        throw inputError(file, Found("over 4096 patches").expected("at most 4096"));
    const bool cap = lower == 0.0 && phis == 1.0;
    const double middle = cap ? 0.0 : 0.5 * (lower + upper);
    const bool given = !childText(block, "Theta").empty();
    basis.addRing(given ? numberIn(file, block, "Theta") : middle, upper, size_t(phis));
    end = upper;
}

}  // namespace

void KlemsBasis::addRing(double theta, double upper, size_t phis)
{
    rings_.push_back({std::cos(upper * kDegree), phis, centres_.size()});
    for (size_t k = 0; k < phis; ++k)
        centres_.push_back(directionFromDegrees(theta, 360.0 * double(k) / double(phis)));
}

size_t KlemsBasis::patchOf(const Vec3d& w) const
{
    const auto ring = std::find_if(rings_.begin(), rings_.end() - 1,
                                   [&](const Ring& r) { return w.z > r.cosUpper; });
    const double turn = std::atan2(w.y, w.x) / (2.0 * kPi) * double(ring->phis);
    const long phis = static_cast<long>(ring->phis);
    return ring->first + static_cast<size_t>((std::lround(turn) % phis + phis) % phis);
}

std::map<std::string, KlemsBasis> klemsBases(const InputFile& file, const pugi::xml_node& root)
{
    std::map<std::string, KlemsBasis> bases;
    for (const auto& [name, rings] : kKnownBases) bases[name] = basisFrom(rings);
    for (const pugi::xml_node& node : elementsNamed(root, "AngleBasis")) {
        KlemsBasis basis;
        double end = 0.0;
        for (const pugi::xml_node& block : elementsNamed(node, "AngleBasisBlock"))
            addBlock(file, block, basis, end);
        const std::string name = lowerCase(childText(node, "AngleBasisName"));
        if (basis.patches() > 0) bases[name] = basis;
    }
    return bases;
}

}  // namespace fbrdf
