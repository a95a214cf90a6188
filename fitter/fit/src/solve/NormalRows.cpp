// Rows of normal equations, block by block, as the kernels of RowKernel.h take them.
#include "solve/LeastSquaresRows.h"

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

}  // namespace

FoldGroups groupsOf(const std::vector<int>& folds, int excluded)
{
    FoldGroups groups{};
    for (size_t k = 0; k < folds.size(); ++k)
        groups[static_cast<size_t>(folds[k])] = static_cast<unsigned char>(k + 1);
    if (excluded != kNoFold) groups[static_cast<size_t>(excluded)] = kNoGroup;
    return groups;
}

// A row a channel: the texels are the same in all of them, the levels, one a term, are not. A
// level stands behind the texels of its term.
void LeastSquares::repeatForChannels(const RowGeometry& geometry, NormalRows& made) const
{
    const auto width = static_cast<size_t>(maker_.width());
    made.unknown.clear();
    made.weight.clear();
    for (size_t i = 0; i < geometry.count; ++i)
        for (int c = 0; c < 3; ++c) {
            size_t k = 0;
            for (size_t t = 0; t < form_.terms.size(); ++t) {
                for (; k < static_cast<size_t>(maker_.termEnd()[t]); ++k) {
                    made.unknown.push_back(geometry.unknown[i * width + k]);
                    made.weight.push_back(geometry.weight[i * width + k]);
                }
                made.unknown.push_back(layout_.levelOf(t, c));
                made.weight.push_back(1.0f);
            }
        }
}

void LeastSquares::describeRows(const RowGeometry& geometry, const Pass& pass,
                                NormalRows& made) const
{
    const bool shared = layout_.sharedShape();
    made.termEnd = maker_.termEnd();
    int before = 0;  // levels before the banded entries
    for (size_t t = 0; shared && t < made.termEnd.size(); ++t) {
        if (made.termEnd[t] <= maker_.bandedFirst()) ++before;
        made.termEnd[t] += static_cast<int>(t) + 1;
    }
    made.entryLanes = pass.channels == 1 || form_.terms.size() == 1 ? 1 : static_cast<int>(kLanes);
    made.rows = {static_cast<std::ptrdiff_t>(made.group.size()),
                 made.termEnd.back(),
                 shared ? made.unknown.data() : geometry.unknown.data(),
                 shared ? made.weight.data() : geometry.weight.data(),
                 made.share.empty() ? nullptr : made.share.data(),
                 made.termEnd.data(),
                 static_cast<std::ptrdiff_t>(made.termEnd.size()),
                 maker_.bandedFirst() + before,
                 maker_.bandedLast() + before,
                 made.sampleWeight.data(),
                 made.residual.data(),
                 made.group.data()};
}

void LeastSquares::makeNormalRows(const RowStore::Block& block, const RowOptions& with,
                                  NormalRows& made) const
{
    const size_t terms = form_.terms.size(), repeats = layout_.sharedShape() ? 3 : 1,
                 count = block.geometry.count * repeats;
    made.group.assign(count, kNoGroup);
    made.sampleWeight.resize(count * kLanes);
    made.residual.resize(count * kLanes);
    made.share.assign(terms > 1 ? count * terms * kLanes : 0, 0.0f);
    const bool oneGroup = isOneGroup(with.groups);
    Predicted predicted;
    predict(block.geometry, 0, block.geometry.count, with.texels, predicted);
    for (size_t i = 0; i < block.geometry.count; ++i) {
        const auto fold =
            oneGroup ? size_t{0} : static_cast<size_t>(foldOf(block.geometry.number(i), seed_));
        if (with.groups[fold] == kNoGroup) continue;
        const Row row = rowAt(block, i, &predicted.logG[i * kLanes], with.options, with.scale);
        for (size_t c = 0; c < repeats; ++c) {
            const size_t at = i * repeats + c, first = with.pass.first + c;
            made.group[at] = with.groups[fold];
            setLanes(row.sampleWeight, first, with.pass.channels, &made.sampleWeight[at * kLanes]);
            setLanes(row.residual, first, with.pass.channels, &made.residual[at * kLanes]);
            for (size_t t = 0; terms > 1 && t < terms; ++t)
                std::copy_n(&predicted.share[(i * terms + t) * kLanes + first], with.pass.channels,
                            &made.share[(at * terms + t) * kLanes]);
        }
    }
    if (layout_.sharedShape()) repeatForChannels(block.geometry, made);
    describeRows(block.geometry, with.pass, made);
}

}  // namespace fbrdf
