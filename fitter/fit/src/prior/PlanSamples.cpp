// Greedy A-optimal design. With the covariance C of the unknowns after the samples chosen so far, a
// further sample with row a lowers trace(B C) by |W^T C a|^2 / (a^T C a + s^2), where B = W W^T is
// what is seen of the unknowns; C a and W^T C a of every pair in a pool follow from pick to pick by
// one product (Fedorov 1972, section 2.7; Nielsen et al. 2015 for reflectance).
#include <fbrdf/fit/SamplePlan.h>

#include "prior/PriorCovariance.h"
#include "prior/PriorSample.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/metrics/SampleSets.h>
#include <fbrdf/metrics/Sobol.h>

#include <Eigen/Eigenvalues>

#include <cmath>

namespace fbrdf {
namespace {

using Index = Eigen::Index;

constexpr size_t kPool = 5000;
constexpr Index kSeenRank = 60;
// Of natural logarithms: what a table leaves the modes by, and the variance of a sample.
constexpr double kTau = 0.1, kNoiseVariance = 0.01;

DirectionPair<double> candidateAt(PlanSpace space, const std::array<double, 4>& u)
{
    HalfDifference angles{u[0] * u[0] * kPi / 2.0, 0.0, u[1] * kPi / 2.0, u[2] * kPi};
    if (space == PlanSpace::planeOfIncidence) angles.phi_d = u[2] < 0.5 ? 0.0 : kPi;
    return pairFromHalfDifference(angles);
}

SamplePlan poolOf(PlanSpace space)
{
    const double least = std::sin(kMinElevation);
    SamplePlan pool;
    for (uint32_t i = 0; pool.size() < kPool; ++i) {
        const auto pair = candidateAt(space, sobolPoint(i, 0));
        if (pair.wo.z > least && pair.wi.z > least) pool.push_back(pair);
    }
    return pool;
}

PriorMatrix rowsOf(const SamplePlan& pool, const Form& form, const Layout& layout)
{
    const RowMaker maker(form, layout);
    const auto width = static_cast<size_t>(maker.width());
    std::vector<int> unknown(width);
    std::vector<float> weight(width);
    PriorMatrix rows = PriorMatrix::Zero(static_cast<Index>(pool.size()), layout.unknowns());
    for (size_t i = 0; i < pool.size(); ++i) {
        maker.make({Vec3f(pool[i].wo), Vec3f(pool[i].wi), {}}, unknown.data(), weight.data());
        for (size_t k = 0; k < width; ++k)
            rows(static_cast<Index>(i), unknown[k]) += static_cast<double>(weight[k]);
    }
    return rows;
}

// W with W W^T close to B: its largest eigenvalues.
PriorMatrix seenRoot(const KnownMaterials& known, Index unknowns)
{
    const Eigen::Map<const PriorMatrix> seen(known.seen.data(), unknowns, unknowns);
    const Eigen::SelfAdjointEigenSolver<PriorMatrix> eigen(seen);
    const Index rank = std::min(kSeenRank, unknowns);
    return eigen.eigenvectors().rightCols(rank) *
           eigen.eigenvalues().tail(rank).cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

}  // namespace

SamplePlan planSamples(const TablePrior& prior, const KnownMaterials& known, PlanSpace space,
                       size_t count)
{
    if (count > kPool)
        throw Error(ErrorKind::usage, "plan",
                    Found(std::to_string(count)).expected("at most " + std::to_string(kPool)));
    const PriorCovariance covariance(prior);
    const SamplePlan pool = poolOf(space);
    const PriorMatrix rows = rowsOf(pool, prior.form, Layout(prior.form));
    const PriorMatrix root = smoothnessRoot(prior.form), inRoot = rows * root.transpose();
    // C a of every pair: pairs x unknowns.
    PriorMatrix covered = (rows * covariance.modes) * covariance.modes.transpose() +
                          kTau * kTau * kOctave * kOctave * inRoot * root;
    PriorMatrix seen = covered * seenRoot(known, covariance.mean.size());
    PriorVector variance = rows.cwiseProduct(covered).rowwise().sum();
    const double noise = kNoiseVariance * kOctave * kOctave;
    PriorVector isFree = PriorVector::Ones(rows.rows());
    SamplePlan plan;
    while (plan.size() < count) {
        Index pick = 0;
        (isFree.array() * seen.rowwise().squaredNorm().array() / (variance.array() + noise))
            .maxCoeff(&pick);
        plan.push_back(pool[static_cast<size_t>(pick)]);
        const Eigen::RowVectorXd ofPick = covered.row(pick), seenOfPick = seen.row(pick);
        const PriorVector shared = rows * ofPick.transpose();
        const double total = variance(pick) + noise;
        covered.noalias() -= shared / total * ofPick;
        seen.noalias() -= shared / total * seenOfPick;
        isFree(pick) = 0.0;
        variance = (variance.array() - shared.array().square() / total).max(0.0);
    }
    return plan;
}

}  // namespace fbrdf
