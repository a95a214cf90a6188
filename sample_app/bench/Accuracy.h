// Accuracy.h - how accurate the runtime is: every technique, form, target format and version
// against the sum in double at every pixel, and against the bound that each plan states.
#pragma once
#include "bench/LightCost.h"
#include "bench/Options.h"

#include <fbrdf/truth/Deviation.h>

#include <string>
#include <vector>

namespace fbrdf::bench {

struct AccuracyRow {
    std::string version;  ///< versions of the context and of its shaders
    std::string form, technique, format;
    int lights = 0, passes = 0;
    LightCost cost;
    ErrorBound bound;
    truth::Deviation found;
    std::string whyReplaced;  ///< why another technique was taken; "": none was
};

struct Accuracy {
    std::string glRenderer;
    std::vector<AccuracyRow> rows;
    std::vector<std::string> leftOut;  ///< versions for which no context exists, and why
    bool holds() const;                ///< every row is within its bound
};

/// What is measured where options.only is empty: allForms(), and some with recombined maps or
/// filtered in the shader.
std::vector<std::string> accuracyForms();

/// Rows for each of options.lights; options.only: forms (Materials.h), "pqp cube" with recombined
/// maps. Throws Error(gl) where there is no usable GL, Error(usage) for an unknown form.
Accuracy measureAccuracy(const Options& options);

std::string asText(const Accuracy& accuracy);
std::string asJson(const Accuracy& accuracy);

}  // namespace fbrdf::bench
