// Measured parameter sets with names of their own.
#include <fbrdf/sources/Model.h>

namespace fbrdf {
namespace {

struct WardRow {
    const char* name;
    double rho_d, rho_s, alpha_x, alpha_y;
};

/// Ward 1992, the table of measured materials, from his gonioreflectometer.
constexpr WardRow kWard1992[] = {
    {"ward-rolled-brass", 0.10, 0.33, 0.050, 0.16},
    {"ward-brushed-aluminium", 0.15, 0.19, 0.088, 0.13},
    {"ward-lightly-brushed-aluminium", 0.15, 0.19, 0.088, 0.13},  // its full name in the paper
    {"ward-varnished-plywood", 0.33, 0.025, 0.040, 0.11},
    {"ward-white-ceramic-tile", 0.70, 0.050, 0.071, 0.071},
    {"ward-glossy-grey-paper", 0.29, 0.083, 0.082, 0.082},
    {"ward-ivory-computer-plastic", 0.45, 0.043, 0.130, 0.130},
};

std::vector<ModelPreset> wardPresets()
{
    std::vector<ModelPreset> presets;
    for (const WardRow& row : kWard1992)
        presets.push_back({row.name,
                           "ward",
                           "measured, Ward 1992",
                           {{"rho_d", Vec3d(row.rho_d)},
                            {"rho_s", Vec3d(row.rho_s)},
                            {"alpha_x", Vec3d(row.alpha_x)},
                            {"alpha_y", Vec3d(row.alpha_y)}}});
    return presets;
}

}  // namespace

const std::vector<ModelPreset>& modelPresets()
{
    static const std::vector<ModelPreset> presets = wardPresets();
    return presets;
}

}  // namespace fbrdf
