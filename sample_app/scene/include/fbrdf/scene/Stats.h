// Stats.h - what one run of the viewer did, as JSON.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace fbrdf::scene {

/// Least, median and greatest of a list; of an even count the median is the mean of the middle two.
struct Spread {
    double median = 0.0, min = 0.0, max = 0.0;
};
Spread spreadOf(std::vector<double> values);

/// What `path` did.
struct PathStats {
    int samples = 0, bounces = 0;  ///< a pixel; at most
    double noise = 0.0;  ///< estimated error over radiance (noiseOf in fbrdf/truth/PathTracer.h)
};

/// How far two pictures are from each other as they are shown: exposed, and with the tone curve
/// where there is one. See ImageErrors.h.
struct CompareNumbers {
    int pixels = 0;                           ///< that either covers; the others do not count
    double psnrLinear = 0.0, psnrSrgb = 0.0;  ///< dB; infinite for pictures that are equal
    double ssim = 1.0, deltaEItp = 0.0, flip = 0.0;
    double largest = 0.0;  ///< difference of a channel, linear
};

/// One side of a comparison.
struct CompareSideStats {
    std::string name, technique;  ///< as it was asked for, and how it was drawn
    std::string note;             ///< parameters, or what was made of the source; may be empty
    size_t bytes = 0;             ///< of its maps; 0: it has none
    int samples = 0;              ///< a pixel
    double fitSeconds = 0.0;
};

struct CompareStats {
    CompareSideStats a, b;
    std::string mode;
    CompareNumbers numbers;
};

/// A file that was dropped on a window.
struct OpenedStats {
    std::string file;
    std::optional<double> seconds;  ///< from the drop to the first picture with what it holds
    std::string why;                ///< it could not be opened; empty: it could, or is not done yet
};

/// How a window went: milliseconds are from the presentation of a frame to that of the next.
struct WindowStats {
    double firstPictureSeconds = 0.0;  ///< since the start of the program
    int frames = 0;
    double longestFrame = 0.0;
    int framesWhileFitting = 0;
    double longestWhileFitting = 0.0;
    int materialsMade = 0;  ///< by fits and from files, since the window was there
    /// Of those, while something of the panel was held, as a slider is; and how long that was.
    int madeWhileHeld = 0;
    double secondsWhileHeld = 0.0;
    std::vector<OpenedStats> opened;
};

struct Stats {
    std::string backend;  ///< "egl", "osmesa", "window"; "cpu" for techniques without GL
    std::string glRenderer, glVersion;  ///< empty without GL
    std::string technique, mesh;
    /// The technique that the runtime took, and why it did not take `technique`. Both are empty on
    /// the CPU, and the reason where the technique is the same.
    std::string techniqueDrawn, whyReplaced;
    std::string filter;             ///< of maps: "hardware", or "shader" where that does it
    std::string lookUp;             ///< the kind that was asked for, for maps over one direction
    std::string environment;        ///< as it was asked for; empty: none
    std::string environmentNote;    ///< what its file was taken for; empty for a built-in one
    double environmentError = 0.0;  ///< LobeTable::error of the material where it is largest
    std::string whyNoEnvironment;   ///< why a material was drawn without it; empty: none was
    std::string whyNotSampled;  ///< why lobes were drawn instead of directions; empty: none were
    double errorRelative = 0.0, errorAbsolute = 0.0;  ///< ErrorBound (Plan.h); 0 on the CPU
    std::vector<std::string> materials;               ///< names
    std::string evaluated;  ///< "source" or "material": what the BRDF values came from
    int width = 0, height = 0, coveredPixels = 0;
    int samples = 1;  ///< a pixel
    bool ground = false, shadows = false;
    int passes = 0;     ///< of the object that needed most
    int drawCalls = 0;  ///< of all objects
    int lightsGiven = 0, lightsUsed = 0, lightsDropped = 0;
    int maxLookups = 0;  ///< texture look-ups in any pass, counted from the linked programs
    std::optional<PathStats> path;  ///< nothing for other techniques
    std::optional<CompareStats> compare;
    std::optional<WindowStats> window;
    std::string accumulation;          ///< "RGBA32F", ...; "double" on the CPU
    std::vector<double> milliseconds;  ///< one a frame: wall clock, from nothing to finished pixels
};

/// A JSON object: backend, gl_renderer, gl_version (null without GL), technique, mesh, materials,
/// look_up, technique_drawn, why_replaced (null where there is none), error_bound
/// {relative, absolute}, environment {name, note, error, why_not} (null where there is none), path
/// {samples, bounces, noise} (null for pictures without noise), compare {a, b {name, technique,
/// note, bytes, samples, fit_seconds}, mode, pixels, psnr_linear, psnr_srgb (null where infinite),
/// ssim, delta_e_itp, flip, largest} (null for a single picture), window {first_picture_seconds,
/// frames, longest_frame, frames_while_fitting, longest_while_fitting, materials_made,
/// made_while_held, seconds_while_held, opened [{file, seconds, why}]} (null without one),
/// evaluated, size, samples, ground, shadows, covered_pixels, passes, draw_calls, lights {given,
/// used, dropped}, max_lookups, accumulation, frames, clock ("cpu"), milliseconds {median, min,
/// max}.
std::string statsToJson(const Stats& stats);
/// An array of such objects as `compare` above.
std::string compareToJson(const std::vector<CompareStats>& stats);

}  // namespace fbrdf::scene
