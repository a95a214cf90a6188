// Form.h - which product of which tables: docs/method.md, Eq. 4, as data.
//   f ~ sum over terms t of  scale_t  prod over factors k of  F_tk(eta_tk(wo, wi))
// A new form is a new value: solver, file and shader generator read it and need no code of their
// own.
#pragma once
#include <fbrdf/brdf/Projection.h>

#include <string>
#include <vector>

namespace fbrdf {

struct TableSpec {
    std::string name;
    Domain domain;
    /// A 1D table that lives in a uniform array: no look-up.
    bool uniform = false;
};

/// One use of a table; a table used twice (p of pqp) is one set of unknowns.
struct Factor {
    int table = 0;
    Argument argument;
};

struct Term {
    std::vector<Factor> factors;
};

struct Form {
    std::string name;
    std::vector<TableSpec> tables;
    std::vector<Term> terms;
};

/// True for a factor whose value changes with the light direction. The others, such as p(wo), can
/// leave the sum over lights.
bool dependsOnLight(const Factor& factor);
/// True when every factor depends on angles that a rotation about the normal keeps: no tangent
/// frame is needed.
bool isIsotropic(const Form& form);
/// Throws Error(input) naming `where` unless the form can be evaluated: indices in range, arguments
/// that fit domains, sizes and exponents in range.
void validate(const Form& form, const std::string& where);

/// "p[disc 32x32 gamma 0.5](wo) q[...](h) p(wi)": one line, for people.
std::string describe(const Form& form);

/// "wi", "wo", "h", "d", "mirror", or "norm(0.5 wi + 1 wo + 0 n)" of another combination.
std::string directionName(const Direction& direction);
const char* angleName(Angle angle);  ///< "theta_h", ...

// The named forms. `size`: texels on a side of each disc map; `gamma`: see DiscDomain.
/// p(wo) q(h) p(wi): docs/method.md, Eq. 6.
Form formPqp(int size, double gamma);
/// p(wo) q(h) p(wi) r(theta_d), r with `knots` knots in uniforms.
Form formPqpr(int size, double gamma, int knots);
/// Knots along each axis of hdio, at least 2.
struct HdioSizes {
    int h = 64, d = 16;  ///< theta_h and theta_d of T1
    int io = 16;         ///< theta_i and theta_o of T2
};
/// T1(theta_h, theta_d) T2(theta_i, theta_o), T2 symmetric.
Form formHdio(const HdioSizes& sizes);

}  // namespace fbrdf
