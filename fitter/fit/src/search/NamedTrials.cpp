#include "search/NamedTrials.h"

#include "data/Symmetry.h"
#include "forms/NamedForms.h"

namespace fbrdf {
namespace {

// How much f(a, b) differs from f(b, a) where a table that is not symmetric takes errors away, and
// where one over the third angle does.
constexpr double kSeenIfOneWay = 1e-3, kPlainlyOneWay = 1e-2;

// The form at its size, or nothing where it is not within the options.
std::optional<Form> sized(const TrialRuns& runs, const std::string& name)
{
    const FitOptions& options = runs.all().options;
    if (lookupsPerPass(makeForm(name)) > options.lookups) return std::nullopt;
    if (options.resolution > 0) {
        const Form form = makeForm(name, options.resolution);
        return runs.isWithin(form) ? std::optional(form) : std::nullopt;
    }
    return largestFormFor(name, decidingSamples(runs.all()),
                          runs.budget() * (options.sharedShape ? 3 : 1), options.storage);
}

}  // namespace

std::vector<std::string> candidateNames(const Source& source, int terms)
{
    std::vector<std::string> names;
    const auto add = [&](int count, std::initializer_list<const char*> forms) {
        if (count <= terms) names.insert(names.end(), forms.begin(), forms.end());
    };
    if (isIsotropicSource(source)) {
        add(1, {"hdio", "hdg", "hdpio"});
        if (!isReciprocalSource(source, kSeenIfOneWay)) add(1, {"hdpu"});
        // Scattered samples show that they are isotropic only where they are near each other.
        if (!source.evaluate) add(1, {"hdp", "pqpr", "qdio"});
        // Files that interpolate have enough samples for the third angle over half a turn.
        if (source.evaluate && !isReciprocalSource(source, kPlainlyOneWay)) {
            add(1, {"hdsu"});
            add(2, {"u+hdsu"});
        }
        if (!isMirrorSymmetricSource(source)) add(1, {"hdau"});
        add(2, {"gg+hdg", "gg+hdpio", "io+hdio"});
        if (!source.evaluate) add(2, {"io+pqpr"});
        add(3, {"gg+hdg+hdio"});
    } else {
        add(1, {"hdio", "hdpu", "qdg", "qdio", "pqp", "pqpr", "pqtr", "pqpd", "pqpn"});
        add(2, {"gg+qdg", "gg+qdio", "gg+pqpr", "io+hdio", "io+pqpr"});
        add(3, {"gg+hdio+pqpr"});
    }
    return names;
}

std::vector<Candidate> tryNamed(TrialRuns& runs, const std::vector<std::string>& names)
{
    std::vector<Candidate> candidates;
    const auto& prior = runs.prior();
    if (prior && runs.isWithin(prior->form)) {
        candidates.push_back(runs.added(prior->form, "prior"));
        if (runs.all().dataset.rows < kFewestCompared) return runs.tryAll(std::move(candidates));
    }
    for (const std::string& name : names)
        if (const auto form = sized(runs, name)) candidates.push_back(runs.added(*form, "form"));
    return runs.tryAll(std::move(candidates));
}

}  // namespace fbrdf
