#include "solve/ConjugateGradients.h"

#include <fbrdf/base/Assert.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

Lanes dot(const LaneVector& a, const LaneVector& b)
{
    Lanes sum{};
    for (size_t i = 0; i < a.size(); ++i)
        for (size_t l = 0; l < kLanes; ++l) sum[l] += a[i][l] * b[i][l];
    return sum;
}

// a / b, 0 where b is 0: a lane that has converged, or was empty, stays where it is.
Lanes ratio(const Lanes& a, const Lanes& b)
{
    Lanes result{};
    for (size_t l = 0; l < kLanes; ++l) result[l] = b[l] > 0.0 ? a[l] / b[l] : 0.0;
    return result;
}

void addScaled(LaneVector& y, const Lanes& factor, const LaneVector& x)
{
    for (size_t i = 0; i < y.size(); ++i)
        for (size_t l = 0; l < kLanes; ++l) y[i][l] += factor[l] * x[i][l];
}

LaneVector preconditioned(const LaneVector& residual, const LaneVector& diagonal)
{
    LaneVector z(residual.size());
    for (size_t i = 0; i < z.size(); ++i) z[i] = ratio(residual[i], diagonal[i]);
    return z;
}

double worst(const Lanes& residual, const Lanes& right)
{
    const Lanes relative = ratio(residual, right);
    return std::sqrt(*std::max_element(relative.begin(), relative.end()));
}

}  // namespace

ConjugateGradientSummary solveByConjugateGradients(
    const std::function<LaneVector(const LaneVector& p)>& apply, const LaneVector& diagonal,
    const LaneVector& right, const ConjugateGradientOptions& options, LaneVector& x)
{
    FBRDF_ASSERT(diagonal.size(), ==, right.size());
    FBRDF_ASSERT(options.tolerance, >, 0.0);
    x.assign(right.size(), Lanes{});
    LaneVector residual = right, z = preconditioned(residual, diagonal), p = z;
    const Lanes rightSquared = dot(right, right);
    Lanes rz = dot(residual, z);
    ConjugateGradientSummary summary;
    summary.residual = worst(rightSquared, rightSquared);
    while (summary.residual > options.tolerance && summary.iterations < options.maxIterations) {
        const LaneVector ap = apply(p);
        const Lanes alpha = ratio(rz, dot(p, ap));
        addScaled(x, alpha, p);
        Lanes minus = alpha;
        for (double& value : minus) value = -value;
        addScaled(residual, minus, ap);
        z = preconditioned(residual, diagonal);
        const Lanes next = dot(residual, z), beta = ratio(next, rz);
        for (size_t i = 0; i < p.size(); ++i)
            for (size_t l = 0; l < kLanes; ++l) p[i][l] = z[i][l] + beta[l] * p[i][l];
        rz = next;
        ++summary.iterations;
        summary.residual = worst(dot(residual, residual), rightSquared);
    }
    summary.isSolved = summary.residual <= options.tolerance;
    return summary;
}

}  // namespace fbrdf
