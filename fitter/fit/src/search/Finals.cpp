#include "search/Finals.h"

#include "search/SeenErrors.h"

#include <fbrdf/brdf/Material.h>
#include <fbrdf/metrics/StandardSphere.h>

#include <algorithm>

namespace fbrdf {
namespace {

constexpr double kNear = 0.2;    // marks apart
constexpr size_t kMost = 5;      // forms
constexpr double kShare = 0.85;  // of the seconds
constexpr int kSize = 64;        // of the sphere, pixels

// The picture that fits are compared with; nothing where there is no function, or where another
// metric decides.
std::optional<SphereImage> pictureOf(const BrdfFunction& function, const FitOptions& options)
{
    if (!function || options.metric != Metric::log) return std::nullopt;
    return renderStandardSphere(function, kSize, options.threads);
}

void markPicture(Candidate& candidate, const SphereImage& reference, int threads)
{
    const Material& material = candidate.whole->fitted.material;
    const auto fitted = [&material](const Vec3d& wo, const Vec3d& wi) {
        return Vec3d(evaluate<float>(material, Vec3f(wo), Vec3f(wi)));
    };
    const double deltaE =
        imageErrors(renderStandardSphere(fitted, kSize, threads), reference).deltaEItp;
    candidate.whole->allMark = withPicture(candidate.whole->allMark, deltaE);
    for (double& mark : candidate.marks) mark = withPicture(mark, deltaE);
}

}  // namespace

std::vector<Candidate> tryFinals(TrialRuns& runs, const BrdfFunction& function, Candidate best,
                                 std::vector<Candidate> others)
{
    const double mark = best.mark();
    others.erase(std::remove_if(others.begin(), others.end(),
                                [&](const Candidate& c) {
                                    return c.trial == best.trial || c.form.terms.size() > 1 ||
                                           c.mark() > mark + kNear;
                                }),
                 others.end());
    std::sort(others.begin(), others.end(), isBetter);
    const FitOptions& options = runs.all().options;
    const std::optional<SphereImage> reference = pictureOf(function, options);
    std::vector<Candidate> finals;
    double seconds = 0.0;  // of the last one: the next may take as long
    const auto enter = [&](Candidate candidate) {
        const Clock clock;
        runs.fitWhole(candidate);
        seconds = clock.seconds();
        if (reference) markPicture(candidate, *reference, options.threads);
        finals.push_back(std::move(candidate));
    };
    enter(std::move(best));
    for (Candidate& other : others) {
        if (finals.size() == kMost || runs.isLate(kShare, seconds)) break;
        enter(std::move(other));
    }
    return finals;
}

}  // namespace fbrdf
