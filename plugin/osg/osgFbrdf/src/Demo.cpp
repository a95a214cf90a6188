// The brushed metal that osgfxbrowser shows where nobody gave the effect a material.
#include <osgFbrdf/FactorizedBrdf.h>

#include <algorithm>
#include <cmath>

namespace osgFbrdf {
namespace {

constexpr int kSize = 32;
constexpr double kAlongX = 0.12, kAlongY = 0.4;  // roughness
constexpr double kDarkest = -16.0;  // log2: 8-bit codes over 16 octaves are fine enough

/// Table q is log2 of Ward's lobe in the half vector (1992, Eq. 5, without its denominators); the
/// others are 0.
fbrdf::Table tableOf(const fbrdf::TableSpec& spec)
{
    fbrdf::Table table;
    table.name = spec.name;
    table.domain = spec.domain;
    for (int texel = 0; texel < fbrdf::texelCount(spec.domain); ++texel) {
        const auto h = fbrdf::directionFromDiscPosition(std::get<fbrdf::DiscDomain>(spec.domain),
                                                        {texel % kSize, texel / kSize});
        const double slope = (std::pow(h.x / kAlongX, 2.0) + std::pow(h.y / kAlongY, 2.0)) /
                             std::max(h.z * h.z, 1e-6);
        const double value = spec.name == "q" ? std::max(kDarkest, -slope / std::log(2.0)) : 0.0;
        table.texels.insert(table.texels.end(), 3, static_cast<float>(value));
    }
    return fbrdf::quantized(table, fbrdf::Storage::log8);
}

}  // namespace

void FactorizedBrdf::setUpDemo()
{
    fbrdf::Material metal;
    metal.name = "brushed metal";
    metal.form = fbrdf::formPqp(kSize, 0.5);
    for (const fbrdf::TableSpec& spec : metal.form.tables) metal.tables.push_back(tableOf(spec));
    metal.scales.emplace_back(1.6f, 1.2f, 0.55f);
    setMaterial(new MaterialObject(metal));
    setTransfer(fbrdf::Transfer::toneMap);  // the window of the browser shows sRGB codes
}

}  // namespace osgFbrdf
