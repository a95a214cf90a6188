// Plan.h - from (form, number of lights, limits) to the list of passes that draws one object. Pure:
// no GL.
//
// A pass draws the object once. For each fragment it computes
//     [ sum over its lights of E_j cos_j  x ]  sum over its parts of  scale x prod of the part's
//     factors [ x the texel of another surface at the fragment ]
// and combines it with what its surface holds. p(wo) does not depend on the light, so it leaves the
// sum: L = s p(wo) sum_j q(h_j) p(wi_j) [n.wi_j] E_j, and `two-lookup` needs N + 1 passes for pqp,
// never 2 N + N. There is no depth pre-pass: the first pass lays depth (LESS) and replaces, so that
// the nearest fragment wins; every later pass matches it (EQUAL) and blends. Reference: McCool,
// Ang, Ahmad 2001, section 5.
//
// Look-ups are texture fetches that one fragment executes in one pass: a fetch that depends on the
// light counts once for each light of the pass; tables in uniforms cost none.
#pragma once
#include <fbrdf/brdf/Form.h>
#include <fbrdf/plan/Capabilities.h>
#include <fbrdf/plan/Technique.h>
#include <fbrdf/plan/Transfer.h>

#include <optional>
#include <string>
#include <vector>

namespace fbrdf {

/// Colour formats as far as adding up passes depends on them.
enum class ColourFormat { rgba8, rgba16, rgba16f, rgba32f, other };
const char* colourFormatName(ColourFormat format);  ///< "RGBA8", ..., "other"

/// Surfaces that passes write and read. All but the target belong to the renderer, are as large as
/// it, of the format that the plan says, and share one depth buffer. sum stands for the target
/// where a curve follows.
enum class Surface { target, accumulation, scratch, sum };
/// target = value; target += value; target *= value. Alpha becomes 1 with replace and stays after.
enum class Blend { replace, add, multiply };
/// lay: LESS, written; match: EQUAL, not written.
enum class Depth { lay, match };

/// The factors of one term that a pass multiplies.
struct Part {
    int term = 0;
    std::vector<int> factors;  ///< indices into form.terms[term].factors
    bool scaled = false;       ///< times the scale of the term
};

struct Pass {
    std::vector<Part> parts;             ///< empty: black (no light reaches the object)
    int firstLight = 0, lightCount = 0;  ///< 0 lights: nothing in the pass depends on the light
    bool lit = false;                    ///< times irradiance and cosine, summed over the lights
    Surface writes = Surface::target;
    std::optional<Surface> reads;
    Blend blend = Blend::replace;
    Depth depth = Depth::lay;
    Transfer transfer = Transfer::linear;  ///< curved: applied to the value before it is written
    /// Times the value before that: what goes into a UNORM surface is scaled down so that no sum
    /// exceeds 1, what comes out of it is scaled up again.
    double gain = 1.0;
    double largest = 1.0;  ///< of parts and lights, where surfaces are UNORM (Peaks)
    int lookups = 0;       ///< see above; the renderer checks it against the linked programs
};

/// The largest values that occur, channels included, for a sum that must not exceed 1.
struct Peaks {
    std::vector<double> tables;  ///< F of each table of the form
    std::vector<double> scales;  ///< of each term
    std::vector<double> lights;  ///< irradiance of each on the object
};

struct PlanRequest {
    Technique technique = Technique::single;
    int lights = 0;         ///< >= 0
    int lightsPerPass = 8;  ///< where the technique asks for it, >= 1
    int maxLookups = 0;     ///< in any pass; 0: what the technique says
    ColourFormat target = ColourFormat::rgba32f;
    bool offscreen = true;  ///< accumulation and scratch surfaces may be used (a multisampled
                            ///< target cannot: edges would read texels that nothing was drawn to)
    Transfer transfer = Transfer::linear;  ///< a curve comes after the sum over all passes
    bool signs = false;  ///< hasSigns(material): no pass but the last may clamp at 0
    /// Of recombined maps (DirectionMap.h): how far the product of any term may be from that of its
    /// tables, |log2|.
    double recombination = 0.0;
    /// Where no float can be drawn to, a UNORM target may have RGBA8 surfaces if these are known.
    std::optional<Peaks> peaks = {};
};

/// Throws Error(usage) for a request out of range.
void validate(const PlanRequest& request);

/// How far what is stored may be from what the definition gives after exposure and transfer:
///     |stored - exact| <= relative x max(|exact|, mean / 100) + absolute
/// before UNORM clamps to 1. mean: of the pixels that are lit; below a hundredth of it the rounding
/// of the cosine dominates: floats near 1 know a cosine to 1e-7, however small it is. Nothing is
/// claimed of a material with signs, whose terms may cancel: relative is infinite. The derivation
/// is in ErrorBound.cpp.
struct ErrorBound {
    double relative = 0.0, absolute = 0.0;
    double recombination = 0.0;  ///< of the request: what recombined maps add to it, |log2|
};

struct Plan {
    std::vector<Pass> passes;
    ColourFormat surfaces = ColourFormat::rgba32f;      ///< format of all but the target
    ColourFormat accumulation = ColourFormat::rgba32f;  ///< where the lights add up
    int maxLookups = 0;                                 ///< of any pass
    Technique technique = Technique::single;
    ErrorBound error;
    std::string reason;  ///< why there is no plan; empty where there is one
    bool feasible() const { return reason.empty(); }
};

/// A sum in RGBA16F or RGBA8 that is not known better than this, of 1 or of the value, is no
/// picture: there is no such plan.
constexpr double kCoarsestSum = 1.0 / 8.0;

/// Of a plan that draws into a target of a format; `other` counts as RGBA8. recombination: as of a
/// PlanRequest.
ErrorBound errorBound(const Plan& plan, ColourFormat target, double recombination = 0.0);

/// Lights that the uniforms of one pass can hold beside the knots of the form.
int maxLightsInUniforms(const Form& form, const Capabilities& capabilities);

/// The plan with the fewest passes within the limits, or a reason. Sums are RGBA32F where that can
/// be drawn to, else RGBA16F as long as their lights lose little (halves end at 65504), else UNORM,
/// scaled, where its error is smaller than that of one pass. Throws what validate throws.
Plan planPasses(const Form& form, const PlanRequest& request, const Capabilities& capabilities);

}  // namespace fbrdf
