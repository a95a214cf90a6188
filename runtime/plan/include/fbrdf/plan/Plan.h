// Plan.h - from (form, number of lights, limits) to the list of passes that draws one object. Pure:
// no GL.
//
// A pass draws the object once. For each fragment it computes
//     [ sum over its lights of E_j cos_j  x ]  sum over its parts of  scale x prod of the part's
//     factors [ x the texel of another surface at the fragment ] [ + lobes ]
// and blends it into its surface. p(wo) does not depend on the light, so it leaves the sum:
// L = s p(wo) sum_j q(h_j) p(wi_j) [n.wi_j] E_j (docs/method.md, Eq. 2 and 6), and `two-lookup`
// needs N + 1 passes for pqp, never 2 N + N. There is no depth pre-pass: the first pass tests with
// the host's depth function, writes depth and replaces, so that the nearest fragment wins; every
// later pass tests for equal depth and blends. Reference: McCool, Ang, Ahmad 2001, section 5.
//
// Look-ups are texture fetches that one fragment executes in one pass: a fetch that depends on the
// light counts once for each light of the pass; tables in uniforms cost none.
#pragma once
#include <fbrdf/brdf/Form.h>
#include <fbrdf/brdf/Material.h>
#include <fbrdf/plan/Capabilities.h>
#include <fbrdf/plan/Lobes.h>
#include <fbrdf/plan/Technique.h>
#include <fbrdf/plan/Transfer.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace fbrdf {

/// Colour formats as far as adding up passes depends on them.
enum class ColourFormat { rgba8, rgba16, rgba16f, rgba32f, other };
const char* colourFormatName(ColourFormat format);  ///< "RGBA8", ..., "other"

/// A unit in the last place of a format: of floats relative to the value, of fixed point a step.
struct StoreUnit {
    double relative = 0.0, absolute = 1.0 / 255.0;
};

/// By ColourFormat.
using StoreRoundings = std::array<StoreRounding, 5>;

/// Surfaces that passes write and read. All but the target belong to the renderer, are as large as
/// the target, have the plan's format and share one depth buffer. sum stands for the target where a
/// curve follows.
enum class Surface { target, accumulation, scratch, sum };
/// target = value; target += value; target *= value. Alpha becomes 1 with replace and stays after.
enum class Blend { replace, add, multiply };
/// write: the nearer fragment passes and its depth is written; match: equal depth passes and
/// nothing is written.
enum class Depth { write, match };

/// The factors of one term that a pass multiplies.
struct Part {
    int term = 0;
    std::vector<int> factors;  ///< indices into form.terms[term].factors
    bool scaled = false;       ///< times the scale of the term
};

struct Pass {
    std::vector<Part> parts;             ///< empty: no light reaches the object
    LobeShare lobes = {};                ///< added to the product
    int firstLight = 0, lightCount = 0;  ///< 0 lights: nothing in the pass depends on the light
    bool lit = false;                    ///< times irradiance and cosine, summed over the lights
    Surface writes = Surface::target;
    std::optional<Surface> reads;
    Blend blend = Blend::replace;
    Depth depth = Depth::write;
    Transfer transfer = Transfer::linear;  ///< a curve is applied to the value before it is written
    /// The value is multiplied by this before the transfer: sums are scaled down on their way into
    /// a UNORM surface, so that none exceeds 1, and up again on their way out.
    double gain = 1.0;
    double largest = 1.0;  ///< upper bound of parts times lights, where surfaces are UNORM (Peaks)
    int lookups = 0;       ///< see above; the renderer checks it against the linked programs
};

/// The largest values that occur in any channel, for sums that must not exceed 1.
struct Peaks {
    std::vector<double> tables;  ///< F of each table of the form
    std::vector<double> scales;  ///< scale of each term
    std::vector<double> lights;  ///< irradiance of each light on the object
};

/// Those of a material, without lights. Filtering mixes texels, so nothing that is looked up is
/// larger.
Peaks peaksOf(const Material& material);

/// The largest |log2| that shaders put through exp2 for one product: over terms, the sum over the
/// factors whose tables are logarithmic.
double largestExponent(const Material& material);

/// What mixes the texels of a look-up: the texture unit, or the shader from single texels
/// (MaterialOptions::precise), whose filtering is as fine as floats.
enum class Filter { hardware, shader };
const char* filterName(Filter filter);  ///< "hardware", "shader"

/// How far what is looked up may be from the tables.
struct MapErrors {
    /// By how much recombined maps (DirectionMap.h) may move the product of any term, |log2|.
    double recombination = 0.0;
    /// By how much the context's filter may move it (FilterPrecision), |log2|.
    double filtering = 0.0;
    /// By how much that filter may move the radiance through maps that are not logarithmic.
    double absolute = 0.0;
    /// The largest |log2| of a product of the material (largestExponent): exp2 may be off by more
    /// units in the last place, the farther from 0 it is asked.
    double exponent = 0.0;
};

struct PlanRequest {
    Technique technique = Technique::single;
    int lights = 0;            ///< >= 0
    int lightsPerPass = 8;     ///< where the technique asks for it, >= 1
    int maxLookups = 0;        ///< in any pass; 0: no limit but the technique's own
    LobeLayout lobes = {};     ///< of the material, by which it reflects lobeLight
    LobeLight lobeLight = {};  ///< drawn with the lights; empty where there are no lobes
    double lobeError = 0.0;    ///< LobeTable::error of those lobes
    /// Directions of the environment that are drawn by the lobes instead of looking those up, in a
    /// pass of their own; 0: none. Technique::single without a limit of look-ups only.
    int environmentSamples = 0;
    ColourFormat target = ColourFormat::rgba32f;
    StoreUnit otherUnit = {};  ///< of a target whose format is `other`
    /// Accumulation and scratch surfaces may be used. Beside a multisampled target they need as
    /// many samples (`resolves`): else its edges would read texels that nothing was drawn to.
    bool offscreen = true;
    /// Surfaces have several samples, whose mean is read (ProgramSpec::resolved): they are floats.
    bool resolves = false;
    Transfer transfer = Transfer::linear;  ///< a curve comes after the sum over all passes
    bool signs = false;                ///< hasSigns(material): no pass but the last may clamp at 0
    Filter filter = Filter::hardware;  ///< of the maps: does not change the plan but its error
    MapErrors maps = {};
    /// Where the peaks are known, sums may be scaled into UNORM surfaces and halves.
    std::optional<Peaks> peaks = {};
    /// The format of surfaces; empty: the smallest one whose error is bounded (planPasses). One
    /// that the context does not have, or whose error would be no picture, is replaced likewise.
    std::optional<ColourFormat> accumulation = {};
    StoreRoundings roundings = {};
};

/// Throws Error(usage) for a request out of range.
void validate(const PlanRequest& request);

/// How far the stored colour may be from the exact one after exposure and transfer:
///     |stored - exact| <= relative x max(|exact|, mean / 100) + absolute
/// before UNORM clamps to 1. mean is that of the lit pixels; below a hundredth of it the rounding
/// of the cosine dominates, whose absolute error is 1e-7 however small the cosine is. Nothing is
/// claimed for a material with signs, whose terms may cancel: relative is infinite. Nor does it
/// include how far lobes are from the material (LobeTable::error) and how coarsely their cube is
/// filtered. The derivation is in ErrorBound.cpp.
struct ErrorBound {
    double relative = 0.0, absolute = 0.0;
    MapErrors maps = {};  ///< PlanRequest::maps, which both include
};

struct Plan {
    std::vector<Pass> passes;
    ColourFormat surfaces = ColourFormat::rgba32f;      ///< format of all but the target
    ColourFormat accumulation = ColourFormat::rgba32f;  ///< format in which the lights add up
    /// Why that format was taken, where there was a choice; a sentence without its full stop.
    std::string whyAccumulation;
    bool resolves = false;  ///< PlanRequest::resolves
    int maxLookups = 0;     ///< the largest Pass::lookups
    Technique technique = Technique::single;
    Filter filter = Filter::hardware;
    ErrorBound error;
    /// LobeTable::error where lobes are drawn: expected, not bounded; 0 without, and where
    /// directions are drawn instead.
    double lobeError = 0.0;
    std::string reason;  ///< why there is no plan; empty where there is one
    bool feasible() const { return reason.empty(); }
};

/// Plans that add up in RGBA16F or RGBA8 are rejected when their error, relative or absolute,
/// exceeds this.
constexpr double kCoarsestSum = 1.0 / 8.0;

/// What sums in a smaller format than RGBA32F may add to the error of a stored colour: half a step
/// of a UNORM target, and nothing of a float target. Whatever is converted to the nearest code is
/// then at most a step off, which OpenGL grants the conversion alone.
double sumTolerance(ColourFormat target, const StoreUnit& other = {});

/// The error of a plan that draws into a target of a format; other: the unit of `other`.
ErrorBound errorBound(const Plan& plan, ColourFormat target, const MapErrors& maps = {},
                      const StoreRoundings& roundings = {}, const StoreUnit& other = {});

/// vec4 uniforms that a pass has for lights and lobes beside the knots of the form; may be
/// negative.
int freeUniformVectors(const Form& form, const Capabilities& capabilities);
/// How many lights fit into the uniforms of one pass beside its lobes, at least 1.
int maxLightsInUniforms(const Form& form, const Capabilities& capabilities,
                        const LobeShare& lobes = {});

/// The plan with the fewest passes within the limits, or a reason why there is none. Sums for a
/// UNORM target, with peaks, are scaled into the first of RGBA8, RGBA16F and RGBA16 whose error is
/// within sumTolerance, but not where a CPU draws, to which RGBA32F costs least. Otherwise they are
/// RGBA32F where that can be drawn to, else RGBA16F while few enough lights add up for its error
/// (kCoarsestSum; halves end at 65504), else scaled UNORM where its error is smaller than that of
/// one pass. Lobes need sums in floats or a single pass. Expects a form that validate accepts.
/// Throws what validate throws.
Plan planPasses(const Form& form, const PlanRequest& request, const Capabilities& capabilities);

}  // namespace fbrdf
