// LobeTable.h - how a material reflects light that comes from everywhere: for each view direction a
// sum of lobes that are the same for all materials, so that one prefiltered environment serves them
// all (docs/method.md, Environment light).
//   integral of f(wo, wi) L(wi) cos theta_i  ~  w_0 L_6(n) + sum over lobes k of  w_k
//   L_level_k(axis_k)
// where L_l is the environment convolved with a lobe of level l.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <array>
#include <string>
#include <vector>

namespace fbrdf {

/// Levels of lobes, 0 to kLobeLevels - 1: the narrowest has width 2^-6; the last is the cosine.
constexpr int kLobeLevels = 7;
constexpr int kCosineLevel = kLobeLevels - 1;

/// The width s of a level, 2^(level - 6): for fractional levels too.
double lobeWidth(double level);

/// Value in 1/sr, at an angle whose cosine is given, of the clamped cosine stretched by
/// diag(s, s, 1) (Heitz, Dupuy, Hill, Neubelt 2016, "Real-Time Polygonal-Light Shading with
/// Linearly Transformed Cosines", Eq. 1): its integral is 1, and it is 0 beyond 90 degrees.
double stretchedCosine(double cosine, double width);
/// The lobe of a level from 0 to 6; between two levels it is their linear mixture, as a texture
/// unit filters between levels.
double lobeValue(double cosine, double level);

/// The most lobes of a table, without the cosine; of tilted ones there are fewer.
constexpr int kMostLobes = 7, kMostTiltedLobes = 3;

/// Where the axes of lobes are.
enum class LobeAxes {
    /// In the plane of n and the mirror direction r of wo: r turned towards n by
    /// tilt x lobeWidth(level) radians. For isotropic materials.
    tilted,
    /// The mirror directions of wo about bent normals n + spread (k - (lobes - 1) / 2) t, where t
    /// is the tangent or, for `acrossTangent`, the bitangent, on wo's side of the surface: -t where
    /// wo . t < 0. For anisotropic materials.
    bent,
};

struct Lobe {
    Vec3f weight{0.0f};  ///< >= 0
    float level = 0.0f;  ///< 0 to 6
    float tilt = 0.0f;   ///< see LobeAxes::tilted; 0 for bent ones
};

/// The lobes of one view direction. At a knot cosine + sum of weights is the directional albedo.
struct LobeKnot {
    Vec3f cosine{0.0f};  ///< weight of the cosine about the normal, >= 0
    std::array<Lobe, kMostLobes> lobes{};
};

struct LobeTable {
    LobeAxes axes = LobeAxes::tilted;
    int lobes = 0;     ///< 1 to 3 tilted ones; 1, 3, 5 or 7 bent ones
    int thetas = 0;    ///< knots over theta_o, at lobeKnotAngle
    int azimuths = 1;  ///< knots over phi_o folded to [0, pi / 2], 1 for isotropic tables
    float spread = 0.0f;
    bool acrossTangent = false;
    /// thetas x azimuths, theta contiguous.
    std::vector<LobeKnot> knots;
    /// The expected error of light under an environment of the prior (LobeFit.h), relative to the
    /// expected light: root of mean squares over view directions.
    double error = 0.0;
    /// The same for draws that ask for 1, 2, ... lobes and get fewer than all (withFewerLobes,
    /// fbrdf/plan/Lobes.h), or none where they are not known.
    std::vector<double> fewerErrors = {};

    bool isEmpty() const { return lobes == 0; }
};

/// theta_o of knot i of `count`: 89 degrees (1 - (1 - i / (count - 1))^1.5), dense at grazing.
double lobeKnotAngle(int knot, int count);

/// Throws Error(input) naming `where` unless numbers are finite and in range and there are as many
/// knots as promised. An empty table is valid.
void validate(const LobeTable& table, const std::string& where);

/// The lobes of one view direction, interpolated between knots.
template <class T>
struct LobeSum {
    Vec3<T> cosine{T(0)};
    int lobes = 0;
    std::array<Vec3<T>, kMostLobes> weight{}, axis{};  ///< axes are unit, local frame
    std::array<T, kMostLobes> level{};
};
/// Expects a table that validate accepts and is not empty, and a unit wo above the horizon. Twin:
/// fbrdfThetaPosition, fbrdfLobeKnot and the axes.
template <class T>
LobeSum<T> lobesAt(const LobeTable& table, const Vec3<T>& wo);

}  // namespace fbrdf
