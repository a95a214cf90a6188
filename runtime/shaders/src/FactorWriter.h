// FactorWriter.h - writes the factors of a form as GLSL statements.
#pragma once
#include "FragmentWriter.h"

#include <set>
#include <string>

namespace fbrdf {

inline const Factor& factorOf(const FragmentContext& c, const Part& part, int index)
{
    return c.form.terms[static_cast<size_t>(part.term)].factors[static_cast<size_t>(index)];
}

inline const TableSpec& tableOf(const FragmentContext& c, const Factor& factor)
{
    return c.form.tables[static_cast<size_t>(factor.table)];
}

inline const TableEncoding& encodingOf(const FragmentContext& c, const Factor& factor)
{
    return c.encodings[static_cast<size_t>(factor.table)];
}

template <class Visit>
void forEachFactor(const FragmentContext& c, Visit visit)
{
    for (const Part& part : c.spec.parts)
        for (const int index : part.factors) visit(factorOf(c, part, index));
}

/// True where directions must be in the tangent frame.
bool needsLocalFrame(const FragmentContext& c);
bool dependsOnLight(const FragmentContext& c);
/// Names of the variables that arguments use: "theta_h", "h", ...
std::set<std::string> variablesUsed(const FragmentContext& c);

/// Declares the axes over angles of the view that belong to factors which also depend on the light.
std::string viewAxisLines(const FragmentContext& c);
/// Declares, in an instanced program, the values that a program of one material has in uniforms; ""
/// in the latter.
std::string parameterLines(const FragmentContext& c);
/// The sum of the lower ends of all ranged logs of a part. It does not depend on the light even
/// where the texels do.
std::string lowers(const FragmentContext& c, const Part& part);
/// Statements that bring the factors of a part into exponent<suffix> and product<suffix>: those
/// factors that depend on the light (ofLight), or the others.
std::string factorsOf(const FragmentContext& c, const Part& part, bool ofLight,
                      const std::string& suffix, const std::string& indent);

}  // namespace fbrdf
