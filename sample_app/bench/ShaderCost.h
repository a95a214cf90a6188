// ShaderCost.h - what a fragment shader computes and fetches, counted in its text.
#pragma once
#include <map>
#include <string>
#include <vector>

namespace fbrdf::bench {

/// The rule: every scalar multiplication and every scalar addition of floats counts one, so that a
/// dot product of vec3 has three and two, and mix two and one each component less where a compiler
/// may fuse them; divisions, roots, exponentials, logarithms and functions of angles count one
/// special each component (pow two, and division by a literal one multiplication). Signs, minima,
/// comparisons, swizzles, constructors and integers are free. Of two branches the dearer counts,
/// unless constants decide; loops count their steps.
struct ShaderCost {
    double multiplications = 0.0, additions = 0.0, specials = 0.0;
    std::map<std::string, double> fetches;  ///< by sampler

    /// Multiplications that take an addition along, and the additions or multiplications that are
    /// left.
    double multiplyAdds() const
    {
        return multiplications > additions ? multiplications : additions;
    }
    ShaderCost& operator+=(const ShaderCost& other);
    ShaderCost operator*(double times) const;
};

/// The cost of main() for one fragment. values: of ints that decide how often loops run, such as
/// fbrdfLightCount. The text is GLSL as the runtime and the peers write it: expressions, for, if,
/// return, functions that are defined before they are called; lines that begin with # are skipped.
/// Throws Error(usage) for anything else.
ShaderCost costOf(const std::string& fragmentSource, const std::map<std::string, double>& values);

}  // namespace fbrdf::bench
