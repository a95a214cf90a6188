#include "SampleSymmetry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace fbrdf {
namespace {

constexpr float kCell = 3.0f * float(kDegree);  // what counts as the same angles
// Whole degrees, which most measurements have, must not lie on the border of two cells.
constexpr float kShift = 0.37f * float(kDegree);
constexpr float kPole = 0.5f * float(kDegree);  // nearer to the normal a direction has no azimuth
constexpr float kPlane =
    2.0f * float(kDegree);  // from the plane of incidence; nearer is on no side
constexpr float kTurned = 10.0f * float(kDegree);  // azimuths that differ by more are turned
constexpr size_t kNeighbours = 4;  // of the same cell that a sample is compared with
constexpr size_t kFewestPairs = 16;
constexpr double kSame = 0.02;   // difference over sum that nothing of ours resolves
constexpr double kAsNear = 1.3;  // times the difference of near samples

/// What a turn about the normal changes of a sample, and what is compared.
struct Turned {
    float azimuth;  ///< of wi, or of wo where wi is nearer to the normal
    int side;       ///< of the plane of incidence: -1, 1, or 0 within it
    Vec3f f, root;  ///< f, where negative 0, and its cube root
};

/// Samples by the angles that a turn about the normal keeps.
class TurnedSamples {
public:
    explicit TurnedSamples(const std::vector<Sample>& samples)
    {
        order_.reserve(samples.size());
        turned_.reserve(samples.size());
        for (const Sample& sample : samples) add(sample);
        std::sort(order_.begin(), order_.end());
    }

    size_t size() const { return order_.size(); }
    /// By cells, and in the order of the file within each.
    const Turned& operator[](size_t i) const { return turned_[order_[i] & 0xFFFFFFFFu]; }
    bool areInOneCell(size_t i, size_t j) const { return order_[i] >> 32 == order_[j] >> 32; }

private:
    void add(const Sample& s);

    std::vector<uint64_t> order_;  ///< cell << 32 | index
    std::vector<Turned> turned_;
};

float zenithOf(const Vec3f& w)
{
    return std::atan2(std::sqrt(w.x * w.x + w.y * w.y), w.z);
}

/// Wraps an angle into [-pi, pi].
float wrapped(float angle)
{
    return std::remainder(angle, float(2.0 * kPi));
}

void TurnedSamples::add(const Sample& s)
{
    const float i = zenithOf(s.wi), o = zenithOf(s.wo);
    const float phiI = std::atan2(s.wi.y, s.wi.x), phiO = std::atan2(s.wo.y, s.wo.x);
    const float between = std::min(i, o) < kPole ? 0.0f : wrapped(phiO - phiI);
    const float across = std::min(std::abs(between), float(kPi) - std::abs(between));
    const auto step = [](float angle) { return uint64_t((angle + kShift) / kCell); };
    const uint64_t cell = step(i) << 16 | step(o) << 8 | step(std::abs(between));
    order_.push_back(cell << 32 | turned_.size());
    const Vec3f f = glm::max(s.f, Vec3f(0.0f));
    turned_.push_back({i < o ? phiO : phiI, across < kPlane ? 0 : (between < 0.0f ? -1 : 1), f,
                       Vec3f(std::cbrt(f.x), std::cbrt(f.y), std::cbrt(f.z))});
}

/// Differences over sums: of f, which sees highlights, and of its cube root, which sees the rest.
struct Disagreement {
    size_t pairs = 0;
    std::array<double, 2> difference{}, sum{};

    void add(const Turned& a, const Turned& b)
    {
        ++pairs;
        add(0, a.f, b.f);
        add(1, a.root, b.root);
    }
    void add(size_t k, const Vec3f& a, const Vec3f& b)
    {
        for (int c = 0; c < 3; ++c) {
            const double x = double(a[c]), y = double(b[c]);
            difference[k] += std::abs(x - y);
            sum[k] += x + y;
        }
    }
    double share(size_t k) const
    {
        return pairs < kFewestPairs || !(sum[k] > 0.0) ? 0.0 : difference[k] / sum[k];
    }
};

bool isTurned(const Turned& a, const Turned& b)
{
    return a.side * b.side < 0 || std::abs(wrapped(a.azimuth - b.azimuth)) > kTurned;
}

}  // namespace

bool areIsotropic(const std::vector<Sample>& samples)
{
    const TurnedSamples turned(samples);
    Disagreement near, far;
    for (size_t i = 0; i < turned.size(); ++i)
        for (size_t j = i + 1; j < std::min(turned.size(), i + 1 + kNeighbours); ++j) {
            if (!turned.areInOneCell(i, j)) break;
            (isTurned(turned[i], turned[j]) ? far : near).add(turned[i], turned[j]);
        }
    if (far.pairs < kFewestPairs) return false;
    for (size_t k = 0; k < 2; ++k)
        if (far.share(k) > kSame + kAsNear * near.share(k)) return false;
    return true;
}

bool hasIsotropicSamples(const Source& source)
{
    if (!source.stream) return areIsotropic(source.samples);
    // Each piece lies at another place of its step: a grid may have as many lines as there are
    // pieces, and a fixed place would see one angle of it alone.
    constexpr uint64_t kPieces = 256, kRows = 256;
    constexpr double kGoldenRatio = 0.6180339887498949;  // its multiples fill [0, 1) evenly
    std::vector<Sample> some;
    SampleReport ignored;
    const uint64_t rows = source.stream.rows, step = std::max(kRows, rows / kPieces);
    double place = 0.0;
    for (uint64_t start = 0; start < rows; start += step) {
        const uint64_t first = start + static_cast<uint64_t>(place * double(step - kRows));
        if (first >= rows) break;
        source.stream.read(first, static_cast<size_t>(std::min(kRows, rows - first)), some,
                           ignored);
        place = std::fmod(place + kGoldenRatio, 1.0);
    }
    return areIsotropic(some);
}

}  // namespace fbrdf
