#include "BentFit.h"
#include "LobeSearch.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Parallel.h>
#include <fbrdf/environment/LobeFit.h>
#include <fbrdf/plan/Lobes.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

namespace fbrdf {
namespace {

constexpr double kFirstAngle = 0.75;  // radians; where searches begin
constexpr double kContinuity = 1e-4;
// One more lobe has to take away this share of the squared error, or it is not worth a look-up.
constexpr double kWorthALobe = 0.9;

struct Candidate {
    LobeTable table;
    std::vector<AtomSet> sets = {};
    double cost = 0.0;  ///< expected squared error of light, mean over view directions
};

class TiltedFit {
public:
    TiltedFit(const Reflectance& f, const LobeFitOptions& options)
        : dictionary_(options.threads), threads_(options.threads)
    {
        std::vector<double> thetas;
        for (int i = 0; i < options.thetas; ++i) {
            thetas.push_back(lobeKnotAngle(i, options.thetas));
            // Between knots the table is judged as well.
            if (i > 0) between_.push_back(0.5 * (thetas.back() + thetas[thetas.size() - 2]));
        }
        knots_ = lobeTargets(dictionary_, f, thetas, threads_);
        middles_ = lobeTargets(dictionary_, f, between_, threads_);
    }

    LobeTable best(int most)
    {
        Candidate chosen = bestOf(1, {});
        Candidate last = chosen;
        for (int lobes = 2; lobes <= most; ++lobes) {
            last = bestOf(lobes, last.sets);
            if (last.cost < kWorthALobe * chosen.cost) chosen = last;
        }
        std::vector<double> fewerErrors;
        for (int lobes = 1; keptLobes(chosen.table, lobes) < chosen.table.lobes; ++lobes) {
            Candidate fewer{withFewerLobes(chosen.table, lobes)};
            setError(fewer);
            fewerErrors.push_back(fewer.table.error);
        }
        chosen.table.fewerErrors = fewerErrors;
        return chosen.table;
    }

private:
    Candidate bestOf(int lobes, const std::vector<AtomSet>& fewer) const
    {
        const auto knot = std::find_if(knots_.begin(), knots_.end() - 1,
                                       [](const LobeTarget& t) { return t.theta >= kFirstAngle; });
        const auto first = static_cast<size_t>(knot - knots_.begin());
        std::vector<LobeStart> starts{{first, kContinuity, {}}};
        if (!fewer.empty()) starts.push_back({first, kContinuity, fewer});
        std::vector<Candidate> candidates(starts.size());
        parallelTasks(starts.size(), threads_, [&](size_t i) {
            candidates[i] = judged(searchLobes(dictionary_, knots_, lobes, starts[i]));
        });
        return *std::min_element(
            candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
    }

    Candidate judged(std::vector<AtomSet> sets) const
    {
        Candidate result;
        result.table.lobes = static_cast<int>(sets.front().size());
        result.table.thetas = static_cast<int>(knots_.size());
        for (size_t i = 0; i < knots_.size(); ++i) result.table.knots.push_back(knot(i, sets[i]));
        result.sets = std::move(sets);
        setError(result);
        return result;
    }

    LobeKnot knot(size_t i, const AtomSet& set) const
    {
        std::vector<Projected> lobes;
        std::vector<Lobe> at;
        for (const size_t atom : set) {
            lobes.push_back(dictionary_.projected(atom));
            at.push_back({Vec3f(0.0f), dictionary_.level(atom), dictionary_.tilt(atom)});
        }
        return knotOf(knots_[i], lobes, at);
    }

    void setError(Candidate& candidate) const
    {
        double error = 0.0, energy = 0.0, total = 0.0;
        const auto add = [&](const LobeTarget& target) {
            // As many pixels of a sphere see this angle.
            const double weight = std::sin(target.theta) * std::cos(target.theta);
            error += weight * squaredError(candidate.table, target);
            energy += weight * target.energy;
            total += weight;
        };
        for (const LobeTarget& target : knots_) add(target);
        for (const LobeTarget& target : middles_) add(target);
        candidate.cost = error / total;
        candidate.table.error = energy > 0.0 ? std::sqrt(error / energy) : 0.0;
    }

    double squaredError(const LobeTable& table, const LobeTarget& target) const
    {
        const Vec3d wo(std::sin(target.theta), 0.0, std::cos(target.theta));
        const LobeSum<double> sum = lobesAt(table, wo);
        std::vector<Projected> lobes;
        const Vec3d mirror(-wo.x, 0.0, wo.z), inwards(wo.z, 0.0, wo.x);
        for (size_t k = 0; k < static_cast<size_t>(sum.lobes); ++k) {
            const double angle =
                std::atan2(glm::dot(sum.axis[k], inwards), glm::dot(sum.axis[k], mirror));
            lobes.push_back(dictionary_.lobe(sum.level[k], angle / lobeWidth(sum.level[k])));
        }
        double error = 0.0;
        for (size_t c = 0; c < 3; ++c) {
            Projected rest = target.channels[c];
            const int channel = static_cast<int>(c);
            for (size_t i = 0; i < rest.size(); ++i) {
                auto value = double(target.cosine[i]) * sum.cosine[channel];
                for (size_t k = 0; k < lobes.size(); ++k)
                    value += double(lobes[k][i]) * sum.weight[k][channel];
                rest[i] -= static_cast<float>(value);
            }
            error += dot(rest, rest);
        }
        return error;
    }

    LobeDictionary dictionary_;
    int threads_;
    std::vector<double> between_;
    std::vector<LobeTarget> knots_, middles_;
};

void check(const LobeFitOptions& options)
{
    const auto fail = [](const std::string& found, const char* expected) {
        throw Error(ErrorKind::usage, "lobes", Found(found).expected(expected));
    };
    if (options.lobes < 1 || options.lobes > kMostTiltedLobes)
        fail(std::to_string(options.lobes) + " lobes", "1 to 3");
    if (options.normals < 1 || options.normals > kMostLobes || options.normals % 2 == 0)
        fail(std::to_string(options.normals) + " bent normals", "1, 3, 5 or 7");
    if (options.thetas < 2 || options.thetas > 1024)
        fail(std::to_string(options.thetas) + " knots", "2 to 1024");
}

}  // namespace

LobeFitOptions lobeOptions(int lobes)
{
    LobeFitOptions options;
    options.lobes = lobes;
    options.normals = lobes == 3 ? kMostLobes : 2 * lobes - 1;
    return options;
}

LobeTable fitLobes(const Reflectance& f, bool isotropic, const LobeFitOptions& options)
{
    check(options);
    if (!isotropic) return fitBentLobes(f, options);
    return TiltedFit(f, options).best(options.lobes);
}

LobeTable fitLobes(const Material& material, const LobeFitOptions& options)
{
    return fitLobes([&](const Vec3d& wo, const Vec3d& wi) { return evaluate(material, wo, wi); },
                    isIsotropic(material.form), options);
}

}  // namespace fbrdf
