#include <fbrdf/metrics/Misfit.h>

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Number.h>
#include <fbrdf/base/Parallel.h>
#include <fbrdf/brdf/HalfDifference.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

namespace fbrdf {
namespace {

using Edges = std::array<double, 6>;  // degrees
constexpr Edges kEdgesH{0, 3, 10, 25, 50, 90}, kEdgesD{0, kRetroAngle, 20, 45, 70, 90};
constexpr size_t kSide = kEdgesH.size() - 1, kRegions = kSide * kSide;

// A region counts as wrong when its values are off by half as much again or two thirds, by more
// than noise; when two fifths of its light are wrong; and when it has light enough to be seen.
// Measured paints, fabrics and metals stay below, tape's and a sensor's peaks far above
// (docs/benchmarks.md).
const double kWrongLog = std::log(1.5);
constexpr double kWrongLight = 0.4, kSeenLight = 0.01;
constexpr double kSurelyAbove = 4.0;  // times the noise floor: values below are mostly noise
constexpr size_t kFewest = 5;         // samples that a wrong region must have
constexpr double kFewPairs = 10.0;    // neighbours that separate noise from structure
constexpr double kOutOfLine = 4.0;    // times the scale of all residuals, where they cannot
constexpr double kMostLog = 10.0;     // one absurd ratio counts as e^10
// 1/sr, in place of a fitted value of 0 or less, which has no logarithm: so far below what is
// measured that the residual is -kMostLog.
constexpr double kLeastFitted = 1e-30;
constexpr double kBrightest = 0.99;  // quantile of c f above which light counts no more

size_t binOf(const Edges& edges, double degrees)
{
    size_t bin = 0;
    while (bin + 1 < kSide && degrees >= edges[bin + 1]) ++bin;
    return bin;
}

size_t regionOf(const HalfDifference& a)
{
    return binOf(kEdgesD, a.theta_d / kDegree) * kSide + binOf(kEdgesH, a.theta_h / kDegree);
}

// Cells in which directions count as neighbours: steps of the root of theta_h, of theta_d and of
// both azimuths; or without phi_h, as an isotropic surface has it. No cell is in two regions.
uint64_t cellOf(const HalfDifference& a, size_t region, bool withAzimuth)
{
    constexpr double kRootSteps = 24.0, kSteps = 12.0, kQuarterSteps = 3.0, kTurnSteps = 12.0;
    const auto step = [](double u, double count) {
        return static_cast<uint64_t>(std::max(0.0, u * count));
    };
    uint64_t key = step(std::sqrt(a.theta_h / (0.5 * kPi)), kRootSteps);
    key = key * 64 + step(a.theta_d / (0.5 * kPi), kSteps);
    key = key * 64 + step(std::abs(std::remainder(a.phi_d, kPi)) / (0.5 * kPi), kQuarterSteps);
    key = key * 64 + (withAzimuth ? step((a.phi_h + kPi) / (2.0 * kPi), kTurnSteps) : 0);
    return key * kRegions + region;
}

struct Residuals {
    double count = 0, sum = 0, squares = 0;

    void add(double r)
    {
        ++count;
        sum += r;
        squares += r * r;
    }
    double rms() const { return count > 0.0 ? std::sqrt(squares / count) : 0.0; }
};

// Products of distinct residuals of one cell, averaged over cells as their samples weigh.
struct Products {
    double samples = 0, sum = 0, pairs = 0;

    void add(const Residuals& cell)
    {
        if (cell.count < 2.0) return;
        sum += (cell.sum * cell.sum - cell.squares) / (cell.count - 1.0);
        pairs += 0.5 * cell.count * (cell.count - 1.0);
        samples += cell.count;
    }
    /// The rms that neighbours share; 0 where chance alone might give as much.
    double rms(double whole) const
    {
        constexpr double kSigmas = 3.0;
        if (pairs < kFewPairs) return 0.0;
        const double variance = sum / samples, chance = kSigmas * whole * whole / std::sqrt(pairs);
        return variance > chance ? std::sqrt(variance) : 0.0;
    }
};

// One channel of all samples, by regions.
class ChannelResiduals {
public:
    explicit ChannelResiduals(double brightest) : brightest_(brightest) {}

    void add(const HalfDifference& angles, double cosine, double f, double g)
    {
        const size_t region = regionOf(angles);
        Region& r = regions_[region];
        const double residual =
            std::clamp(std::log(std::max(g, kLeastFitted) / f), -kMostLog, kMostLog);
        r.residuals.add(residual);
        r.difference += cosine * std::abs(g - f);
        r.light += cosine * f;
        r.seen += std::min(cosine * f, brightest_);
        for (const bool withAzimuth : {false, true})
            cells_[withAzimuth][cellOf(angles, region, withAzimuth)].add(residual);
        magnitudes_.push_back(static_cast<float>(std::abs(residual)));
    }

    double seen() const
    {
        double sum = 0.0;
        for (const Region& r : regions_) sum += r.seen;
        return sum;
    }
    double seen(size_t region) const { return regions_[region].seen; }
    const Residuals& residuals(size_t region) const { return regions_[region].residuals; }

    /// Structural rms of every region. `exact`: nothing is noise.
    std::vector<double> structure(bool exact)
    {
        std::array<std::vector<Products>, 2> products;
        for (size_t kind = 0; kind < 2; ++kind) {
            products[kind].resize(kRegions);
            for (const auto& [key, cell] : cells_[kind]) products[kind][key % kRegions].add(cell);
        }
        const double scale = 1.4826 * median();  // of a normal distribution
        std::vector<double> result(kRegions);
        for (size_t region = 0; region < kRegions; ++region) {
            const double whole = regions_[region].residuals.rms();
            const Products &coarse = products[0][region], &fine = products[1][region];
            if (exact || (coarse.pairs < kFewPairs && whole > kOutOfLine * scale))
                result[region] = whole;
            else
                result[region] = std::max(coarse.rms(whole), fine.rms(whole));
        }
        return result;
    }

    bool isWrong(size_t region, double structural, double allSeen) const
    {
        const Region& r = regions_[region];
        return r.residuals.count >= static_cast<double>(kFewest) && structural > kWrongLog &&
               r.difference > kWrongLight * r.light && r.seen > kSeenLight * allSeen;
    }

private:
    struct Region {
        Residuals residuals;
        double difference = 0, light = 0, seen = 0;
    };

    double median()
    {
        if (magnitudes_.empty()) return 0.0;
        const auto middle =
            magnitudes_.begin() + static_cast<std::ptrdiff_t>(magnitudes_.size() / 2);
        std::nth_element(magnitudes_.begin(), middle, magnitudes_.end());
        return static_cast<double>(*middle);
    }

    double brightest_;
    std::array<Region, kRegions> regions_{};
    std::array<std::unordered_map<uint64_t, Residuals>, 2> cells_;
    std::vector<float> magnitudes_;
};

// One spike must not make all other light look like nothing.
double brightestOf(const std::vector<Sample>& samples)
{
    std::vector<float> light;
    for (const Sample& s : samples)
        for (int c = 0; c < 3; ++c) light.push_back(s.wi.z * s.f[c]);
    if (light.empty()) return 0.0;
    const auto rank = light.begin() + static_cast<std::ptrdiff_t>(
                                          kBrightest * static_cast<double>(light.size() - 1));
    std::nth_element(light.begin(), rank, light.end());
    return static_cast<double>(*rank);
}

MisfitRegion emptyRegion(size_t index)
{
    MisfitRegion region;
    region.theta_hFrom = kEdgesH[index % kSide];
    region.theta_hTo = kEdgesH[index % kSide + 1];
    region.theta_dFrom = kEdgesD[index / kSide];
    region.theta_dTo = kEdgesD[index / kSide + 1];
    return region;
}

std::string channelNames(const std::array<bool, 3>& channels)
{
    if (channels[0] && channels[1] && channels[2]) return "all channels";
    std::string names;
    for (size_t c = 0; c < 3; ++c)
        if (channels[c]) names += (names.empty() ? "" : ", ") + std::string(1, "RGB"[c]);
    return names;
}

}  // namespace

std::vector<MisfitRegion> misfitRegions(const std::vector<Sample>& samples,
                                        const std::vector<Vec3f>& fitted, const Vec3f& noiseFloor,
                                        bool exact, int threads)
{
    FBRDF_ASSERT(fitted.size(), ==, samples.size());
    std::vector<ChannelResiduals> channels(3, ChannelResiduals(brightestOf(samples)));
    std::vector<HalfDifference> angles(samples.size());
    parallelFor(samples.size(), threads, [&](size_t i) {
        angles[i] = halfDifferenceFromPair({Vec3d(samples[i].wo), Vec3d(samples[i].wi)});
    });
    parallelTasks(channels.size(), threads, [&](size_t task) {
        const auto c = static_cast<int>(task);
        for (size_t i = 0; i < samples.size(); ++i) {
            const Sample& s = samples[i];
            if (static_cast<double>(s.f[c]) > kSurelyAbove * static_cast<double>(noiseFloor[c]))
                channels[task].add(angles[i], static_cast<double>(s.wi.z),
                                   static_cast<double>(s.f[c]), static_cast<double>(fitted[i][c]));
        }
    });
    double seen = 0.0;
    for (const ChannelResiduals& channel : channels) seen += channel.seen() / 3.0;
    std::vector<MisfitRegion> regions(kRegions);
    for (size_t r = 0; r < kRegions; ++r) regions[r] = emptyRegion(r);
    for (size_t c = 0; c < 3; ++c) {
        const auto structure = channels[c].structure(exact);
        for (size_t r = 0; r < kRegions; ++r) {
            if (!channels[c].isWrong(r, structure[r], seen)) continue;
            const Residuals& residuals = channels[c].residuals(r);
            regions[r].channels[c] = true;
            regions[r].light = std::max(regions[r].light, channels[c].seen(r) / seen);
            regions[r].samples = std::max(regions[r].samples, static_cast<size_t>(residuals.count));
            if (std::exp(structure[r]) <= regions[r].factor) continue;
            regions[r].factor = std::exp(structure[r]);
            regions[r].bias = std::exp(residuals.sum / residuals.count);
        }
    }
    regions.erase(std::remove_if(regions.begin(), regions.end(),
                                 [](const MisfitRegion& r) { return r.samples == 0; }),
                  regions.end());
    std::stable_sort(
        regions.begin(), regions.end(),
        [](const MisfitRegion& a, const MisfitRegion& b) { return a.light > b.light; });
    return regions;
}

std::string describe(const MisfitRegion& region)
{
    std::string line = "theta_h " + numberText(region.theta_hFrom) + " to " +
                       numberText(region.theta_hTo) + ", theta_d " +
                       numberText(region.theta_dFrom) + " to " + numberText(region.theta_dTo) +
                       " degrees";
    if (region.theta_dTo <= kRetroAngle && region.theta_hFrom > 0.0)
        line += " (back towards the light)";
    else if (region.theta_hFrom == 0.0)
        line += " (about the mirror direction)";
    line += ", " + channelNames(region.channels) + ": off by a factor of " +
            numberText(region.factor, 2);
    constexpr double kOneSided = 1.2;
    if (region.bias > kOneSided) line += ", too bright";
    if (region.bias < 1.0 / kOneSided) line += ", too dark";
    return line;
}

Coverage coverageOf(const std::vector<Sample>& samples)
{
    const double kPlane = std::sin(2.0 * kDegree), kPole = std::sin(1.0 * kDegree);
    constexpr double kFewOutside = 0.01;
    Coverage coverage;
    std::set<int> incidences, azimuths;
    size_t beside = 0;
    coverage.theta_iFrom = 90.0;
    for (const Sample& s : samples) {
        const double sine_i = std::hypot(static_cast<double>(s.wi.x), static_cast<double>(s.wi.y));
        const double theta_i = std::atan2(sine_i, static_cast<double>(s.wi.z)) / kDegree;
        coverage.theta_iFrom = std::min(coverage.theta_iFrom, theta_i);
        coverage.theta_iTo = std::max(coverage.theta_iTo, theta_i);
        incidences.insert(static_cast<int>(std::lround(theta_i)));
        if (sine_i < kPole) continue;  // any plane is the plane of incidence
        const Vec3f along = s.wi / static_cast<float>(sine_i);
        azimuths.insert(static_cast<int>(std::lround(
            std::atan2(static_cast<double>(along.y), static_cast<double>(along.x)) / kDegree)));
        const double distance = std::abs(static_cast<double>(along.x * s.wo.y - along.y * s.wo.x));
        if (distance > kPlane) ++beside;
    }
    coverage.incidences = incidences.size();
    coverage.oneAzimuth = azimuths.size() <= 1;
    coverage.inPlane =
        static_cast<double>(beside) <= kFewOutside * static_cast<double>(samples.size());
    return coverage;
}

std::string describe(const Coverage& coverage)
{
    std::string line = coverage.incidences == 1
                           ? "light at " + numberText(coverage.theta_iTo, 3) + " degrees alone"
                           : "light from " + numberText(coverage.theta_iFrom, 3) + " to " +
                                 numberText(coverage.theta_iTo, 3) + " degrees";
    if (coverage.inPlane)
        line += ", view in the plane of incidence only: beside it the material is a guess";
    return line;
}

}  // namespace fbrdf
