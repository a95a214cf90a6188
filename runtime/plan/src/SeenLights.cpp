#include "SeenLights.h"

#include "ClusterTiles.h"

#include <glm/matrix.hpp>

#include <array>
#include <cmath>
#include <cstring>

namespace fbrdf {
namespace {

// So many lights are looked at in the time that waking a thread takes.
constexpr size_t kBlock = 512;

/// The part of eye space that is seen: -w <= x <= w, -w <= y <= w, 0 <= w. Depth is left out, as
/// conventions of it differ.
class View {
public:
    static constexpr size_t kPlanes = 5;

    explicit View(const glm::dmat4& projection)
    {
        const glm::dmat4 rows = glm::transpose(projection);
        const glm::dvec4 planes[kPlanes] = {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1],
                                            rows[3] - rows[1], rows[3]};
        for (size_t k = 0; k < kPlanes; ++k) {
            const double length = glm::length(Vec3d(planes[k]));
            planes_[k] = length > 0.0 ? planes[k] / length : glm::dvec4(0.0, 0.0, 0.0, 1.0);
            floats_[k] = glm::vec4(planes_[k]);
        }
    }

    /// True unless all of the sphere is certain to be outside.
    bool mayMeet(const Reach& reach) const
    {
        for (const glm::dvec4& plane : planes_) {
            const double along = glm::dot(Vec3d(plane), reach.centre);
            const double slack = (kDistanceMargin - 1.0) * (std::abs(along) + std::abs(plane.w));
            if (along + plane.w + slack < -reach.radius * kDistanceMargin) return false;
        }
        return true;
    }

    /// The same in float for the spheres of `count` <= kBlock lights at once, cones left aside:
    /// nothing in the loop branches, so that the compiler can take several lights in a step.
    void mark(const LightVectors* lights, size_t count, char* seen) const
    {
        constexpr float kSlack = 1e-5f;  // above the rounding of a sum of four products
        float x[kBlock], y[kBlock], z[kBlock], w[kBlock], room[kBlock];
        for (size_t i = 0; i < count; ++i) {
            x[i] = lights[i][0].x;
            y[i] = lights[i][0].y;
            z[i] = lights[i][0].z;
            w[i] = lights[i][0].w;
            room[i] = std::numeric_limits<float>::max();
        }
        for (const glm::vec4& plane : floats_)
            for (size_t i = 0; i < count; ++i) {
                const float a = plane.x * x[i], b = plane.y * y[i], c = plane.z * z[i];
                const float size = std::abs(a) + std::abs(b) + std::abs(c) + std::abs(plane.w);
                const float inside = a + b + c + plane.w + kSlack * size;
                room[i] = inside < room[i] ? inside : room[i];
            }
        // Outside by d is out of reach where d^2 / radius^2 is above 1. Lights without a radius
        // have 0 for 1 / radius^2, which must not meet an infinite d^2.
        constexpr float kFar = 1e18f;
        for (size_t i = 0; i < count; ++i) {
            const float outside = std::min(room[i] < 0.0f ? -room[i] : 0.0f, kFar);
            seen[i] = outside * outside * w[i] <= 1.0f + 4.0f * kSlack ? 1 : 0;
        }
    }

private:
    std::array<glm::dvec4, kPlanes> planes_;
    std::array<glm::vec4, kPlanes> floats_;
};

bool isEqual(const LightVectors& a, const LightVectors& b)
{
    // Bytes that are equal are the same light; -0 for 0 merely counts as a change.
    return std::memcmp(&a, &b, sizeof a) == 0;
}

/// Sets the reach of a light that mark() has let pass. Returns whether it may be seen.
bool isSeenWith(const View& view, const LightVectors& light, Reach& reach)
{
    if (isUnlimited(light)) return true;
    reach = reachOf(light);
    // Only a cone makes the sphere smaller than what mark() has looked at.
    return !reach.hasCone() || view.mayMeet(reach);
}

size_t blocksOf(const std::vector<LightVectors>& lights)
{
    return (lights.size() + kBlock - 1) / kBlock;
}

/// Calls look(i, mayBeSeen) for the lights of a block.
template <class Look>
void lookAtBlock(const View& view, const std::vector<LightVectors>& lights, size_t block, Look look)
{
    const size_t first = block * kBlock, last = std::min(lights.size(), first + kBlock);
    char seen[kBlock];
    view.mark(&lights[first], last - first, seen);
    for (size_t i = first; i < last; ++i) look(i, seen[i - first] != 0);
}

/// Added block by block, in their order, so that threads do not change what rounding leaves.
ReachSums sumOf(const std::vector<ReachSums>& blocks)
{
    ReachSums sum;
    for (const ReachSums& block : blocks) sum.add(block);
    return sum;
}

}  // namespace

ReachSums lookAfresh(const std::vector<LightVectors>& lights, const glm::dmat4& projection,
                     KnownLights& known, Workers& workers)
{
    const View view(projection);
    known.slots.resize(lights.size());
    known.reaches.resize(lights.size());
    std::vector<ReachSums> sums(blocksOf(lights));
    workers.run(sums.size(), [&](size_t block) {
        ReachSums sum;  // threads that write beside each other would wait for each other
        lookAtBlock(view, lights, block, [&](size_t i, bool mayBeSeen) {
            const bool isSeen = mayBeSeen && isSeenWith(view, lights[i], known.reaches[i]);
            known.slots[i] = isSeen ? 0 : -1;
            if (isSeen && !isUnlimited(lights[i])) sum.add(known.reaches[i], projection);
        });
        sums[block] = sum;
    });
    return sumOf(sums);
}

size_t Comparison::count() const
{
    size_t sum = 0;
    for (const auto& block : changes) sum += block.size();
    return sum;
}

Comparison compareLights(const std::vector<LightVectors>& lights, const glm::dmat4& projection,
                         const LightClusters& clusters, const KnownLights& known, Workers& workers)
{
    const View view(projection);
    Comparison result;
    result.changes.resize(blocksOf(lights));
    std::vector<ReachSums> sums(result.changes.size());
    workers.run(sums.size(), [&](size_t block) {
        ReachSums sum;
        lookAtBlock(view, lights, block, [&](size_t i, bool mayBeSeen) {
            const int32_t slot = known.slots[i];
            const LightVectors& light = lights[i];
            if (!mayBeSeen && slot < 0) return;
            if (slot >= 0 && isEqual(clusters.lights[static_cast<size_t>(slot)], light)) {
                if (!isUnlimited(light)) sum.add(known.reaches[i], projection);
                return;
            }
            LightChange change{static_cast<int32_t>(i)};
            change.isSeen = mayBeSeen && isSeenWith(view, light, change.reach);
            if (change.isSeen && !isUnlimited(light)) sum.add(change.reach, projection);
            if (change.isSeen || slot >= 0) result.changes[block].push_back(change);
        });
        sums[block] = sum;
    });
    result.sums = sumOf(sums);
    return result;
}

bool manyHaveChanged(const std::vector<LightVectors>& lights, const LightClusters& clusters)
{
    constexpr size_t kSample = 64, kMany = 16;
    const size_t step = std::max<size_t>(1, clusters.lights.size() / kSample);
    size_t changed = 0;
    for (size_t slot = 0; slot < clusters.lights.size(); slot += step) {
        const auto place = static_cast<size_t>(clusters.places[slot]);
        changed += isEqual(clusters.lights[slot], lights[place]) ? 0 : 1;
    }
    return changed >= kMany;
}

}  // namespace fbrdf
