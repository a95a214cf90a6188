// Inputs.h - small synthetic inputs of the tool's tests.
#pragma once
#include <fbrdf/brdf/Material.h>

#include <string>
#include <vector>

namespace fbrdf::test {

constexpr char kPairHeader[] = "wo_x,wo_y,wo_z,wi_x,wi_y,wi_z";
constexpr char kSampleHeader[] = "wo_x,wo_y,wo_z,wi_x,wi_y,wi_z,r,g,b";

/// `count` pairs above the horizon, spread by a Kronecker sequence (no two alike).
std::vector<DirectionPair<double>> spreadPairs(size_t count);

/// "x,y,z,x,y,z" with 17 digits: reads back as the same doubles.
std::string pairText(const DirectionPair<double>& pair);
/// Header and a row a pair.
std::string pairsCsv(const std::vector<DirectionPair<double>>& pairs);

/// Colours of a diffuse base with a gloss, closed form, reciprocal, between 0.05 and 2.
Vec3d glossy(const Vec3d& wo, const Vec3d& wi);
/// Header and `count` rows of glossy(), times `factor`.
std::string samplesCsv(size_t count, double factor = 1.0);

/// A material over small tables of a form ("pqp", "hdio") with smooth texels, float storage.
Material smallMaterial(const std::string& form);

/// Options that make a fit of `glossy` quick: a fixed small form and strength.
std::vector<std::string> quickFit(const std::string& source, const std::string& output);

/// The bytes of a Radiance picture of 8 x 4 texels that is brighter above.
std::string smallSky();

/// Numbers of the fields of a CSV line.
std::vector<double> numbersOf(const std::string& line);

}  // namespace fbrdf::test
