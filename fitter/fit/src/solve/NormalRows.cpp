#include "solve/NormalRows.h"

#include <fbrdf/base/Assert.h>

namespace fbrdf {
namespace {

// The channels of `v` from the first one served on, a lane each.
void setLanes(const Vec3f& v, size_t first, size_t channels, float* lanes)
{
    for (size_t l = 0; l < kLanes; ++l)
        lanes[l] = l < channels ? v[static_cast<int>(first + l)] : 0.0f;
}

bool isOneGroup(const FoldGroups& groups)
{
    return groups[0] != kNoGroup &&
           std::all_of(groups.begin(), groups.end(),
                       [&groups](unsigned char group) { return group == groups[0]; });
}

size_t rowsPerSample(const LeastSquares& problem)
{
    return problem.layout().sharedShape() ? 3 : 1;
}

}  // namespace

FoldGroups groupsOf(const std::vector<int>& folds, int excluded)
{
    FoldGroups groups{};
    for (size_t k = 0; k < folds.size(); ++k) {
        FBRDF_ASSERT(folds[k], !=, excluded);
        groups[static_cast<size_t>(folds[k])] = static_cast<unsigned char>(k + 1);
    }
    if (excluded != kNoFold) groups[static_cast<size_t>(excluded)] = kNoGroup;
    return groups;
}

// One row a channel: all three have the same texels, and each has its own levels. The level of a
// term stands behind the texels of that term.
void NormalRows::repeatForChannels(const LeastSquares& problem, const RowGeometry& geometry)
{
    const auto width = static_cast<size_t>(problem.maker().width());
    const std::vector<int>& termEnd = problem.maker().termEnd();
    unknown_.clear();
    weight_.clear();
    for (size_t i = 0; i < geometry.count; ++i)
        for (int c = 0; c < 3; ++c) {
            size_t k = 0;
            for (size_t t = 0; t < problem.terms(); ++t) {
                for (; k < static_cast<size_t>(termEnd[t]); ++k) {
                    unknown_.push_back(geometry.unknown[i * width + k]);
                    weight_.push_back(geometry.weight[i * width + k]);
                }
                unknown_.push_back(problem.layout().levelOf(t, c));
                weight_.push_back(1.0f);
            }
        }
}

// Sample i has the rows i * repeats + c, where c counts the channels of a shared shape. Row `at`
// has kLanes weights and residuals from at * kLanes on, and the shares of term t from
// (at * terms + t) * kLanes on.
void NormalRows::weigh(const LeastSquares& problem, const RowStore::Block& block,
                       const RowOptions& with)
{
    const size_t terms = problem.terms(), repeats = rowsPerSample(problem),
                 channels = with.pass.channels;
    const bool oneGroup = isOneGroup(with.groups);
    Prediction predicted;
    predict(problem, block.geometry, 0, block.geometry.count, with.texels, predicted);
    for (size_t i = 0; i < block.geometry.count; ++i) {
        const auto fold =
            oneGroup ? size_t{0}
                     : static_cast<size_t>(foldOf(block.geometry.number(i), problem.seed()));
        if (with.groups[fold] == kNoGroup) continue;
        const WeightedRow row = with.weights(block, i, &predicted.logG[i * kLanes]);
        for (size_t c = 0; c < repeats; ++c) {
            const size_t at = i * repeats + c, first = with.pass.first + c;
            group_[at] = with.groups[fold];
            setLanes(row.sampleWeight, first, channels, &sampleWeight_[at * kLanes]);
            setLanes(row.residual, first, channels, &residual_[at * kLanes]);
            for (size_t t = 0; terms > 1 && t < terms; ++t)
                std::copy_n(&predicted.share[(i * terms + t) * kLanes + first], channels,
                            &share_[(at * terms + t) * kLanes]);
        }
    }
}

// Terms end one entry later for every level that stands before their end.
void NormalRows::addLevelsToTerms(const LeastSquares& problem)
{
    termEnd_ = problem.maker().termEnd();
    if (!problem.layout().sharedShape()) return;
    for (size_t t = 0; t < termEnd_.size(); ++t) termEnd_[t] += static_cast<int>(t) + 1;
}

void NormalRows::describe(const LeastSquares& problem, const RowGeometry& geometry,
                          const ChannelPass& pass)
{
    const RowMaker& maker = problem.maker();
    const bool shared = problem.layout().sharedShape();
    addLevelsToTerms(problem);
    const auto levelsBefore =
        std::count_if(maker.termEnd().begin(), maker.termEnd().end(),
                      [&](int end) { return shared && end <= maker.bandedFirst(); });
    entryLanes_ = pass.channels == 1 || problem.terms() == 1 ? 1 : static_cast<int>(kLanes);
    rows_ = {static_cast<std::ptrdiff_t>(group_.size()),
             termEnd_.back(),
             shared ? unknown_.data() : geometry.unknown.data(),
             shared ? weight_.data() : geometry.weight.data(),
             share_.empty() ? nullptr : share_.data(),
             termEnd_.data(),
             static_cast<std::ptrdiff_t>(termEnd_.size()),
             maker.bandedFirst() + levelsBefore,
             maker.bandedLast() + levelsBefore,
             sampleWeight_.data(),
             residual_.data(),
             group_.data()};
}

void NormalRows::make(const LeastSquares& problem, const RowStore::Block& block,
                      const RowOptions& with)
{
    const size_t terms = problem.terms(), count = block.geometry.count * rowsPerSample(problem);
    group_.assign(count, kNoGroup);
    sampleWeight_.resize(count * kLanes);
    residual_.resize(count * kLanes);
    share_.assign(terms > 1 ? count * terms * kLanes : 0, 0.0f);
    weigh(problem, block, with);
    if (problem.layout().sharedShape()) repeatForChannels(problem, block.geometry);
    describe(problem, block.geometry, with.pass);
}

}  // namespace fbrdf
