// PlanSimulator.h - executes a plan on the fragments of one pixel, with numbers for factors, as a
// GPU would: depth test, depth write, blend. The final content of the target is what the plan
// draws.
#pragma once
#include <fbrdf/plan/Plan.h>

#include <vector>

namespace fbrdf {

/// One fragment of the object: its depth and the value of every factor.
struct SimulatedFragment {
    double depth = 0.5;
    /// [term][factor][light]; a factor that does not depend on the light has one value.
    std::vector<std::vector<std::vector<double>>> factor;
    std::vector<double> irradiance;  ///< [light], cosine included
    /// What an environment adds: the cosine, then each lobe; empty where there is none.
    std::vector<double> lobes = {};
    std::vector<std::vector<double>> areaLobes = {};  ///< the same for each area light
};

struct SimulatedPixel {
    double value = 0.0, depth = 1.0;
};

/// A fragment with factors that no two terms, lights, lobes or seeds share; 0.5 to 2.
SimulatedFragment simulatedFragment(const Form& form, int lights, double depth, unsigned seed,
                                    int lobes = 0, const LobeLight& light = {true, 0});

/// The scale of a term in the simulation.
double simulatedScale(int term);

/// The sum over lights and terms, and over lobes, by the definition.
double expectedValue(const Form& form, const SimulatedFragment& fragment);

/// How a context rounds what it stores: to the nearest value of the format, towards 0, or as
/// coarsely as OpenGL grants, where blending cuts the source off too (StoreRounding).
enum class Store { nearest, truncates, coarsest };

/// Draws the fragments in the order given, once for each pass, over the content of the target. The
/// target has a format; UNORM clamps to [0, 1].
SimulatedPixel simulate(const Plan& plan, const std::vector<SimulatedFragment>& fragments,
                        SimulatedPixel target, ColourFormat format = ColourFormat::rgba32f,
                        Store store = Store::nearest);

}  // namespace fbrdf
