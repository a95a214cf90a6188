#include <fbrdf/brdf/Error.h>
#include <fbrdf/fit/Fit.h>

#include <algorithm>
#include <array>

namespace fbrdf {
namespace {

constexpr double kGamma = 0.5;  // the warp that spends texels on the highlight
constexpr int kKnots = 24;      // of r(theta_d)

}  // namespace

const std::vector<NamedForm>& namedForms()
{
    static const std::vector<NamedForm> forms{
        {"pqp", "p(wo) q(h) p(wi)", "anisotropic, reciprocal; N + 1 passes of two look-ups", 32},
        {"pqpr", "p(wo) q(h) p(wi) r(theta_d)", "as pqp; r costs no look-up", 32},
        {"hdio", "T1(theta_h, theta_d) T2(theta_i, theta_o)",
         "isotropic, reciprocal; N passes of two look-ups", 64},
    };
    return forms;
}

Form makeForm(const std::string& name, int resolution)
{
    const auto& forms = namedForms();
    const auto found = std::find_if(forms.begin(), forms.end(),
                                    [&](const NamedForm& f) { return f.name == name; });
    if (found == forms.end()) {
        std::string known;
        for (const NamedForm& f : forms) known += (known.empty() ? "" : ", ") + f.name;
        throw Error(ErrorKind::usage, "form", "found '" + name + "', expected auto, " + known);
    }
    const int n = resolution > 0 ? resolution : found->defaultResolution;
    if (n < 4 || n > 256)
        throw Error(ErrorKind::usage, "resolution",
                    "found " + std::to_string(n) + ", expected 4 to 256");
    if (name == "pqp") return formPqp(n, kGamma);
    if (name == "pqpr") return formPqpr(n, kGamma, kKnots);
    return formHdio(n, std::max(4, n / 4), std::max(4, n / 4));
}

}  // namespace fbrdf
