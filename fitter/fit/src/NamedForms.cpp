#include "NamedForms.h"

#include <fbrdf/brdf/Error.h>

#include <algorithm>
#include <functional>

namespace fbrdf {
namespace {

constexpr double kGamma = 0.5;  // the warp that spends texels on the highlight
constexpr int kKnots = 24;      // of r(theta_d)
constexpr int kMinResolution = 4, kMaxResolution = 256;

Form formIo(int size)
{
    Form form = formHdio(2, 2, size);
    form.name = "io";
    form.tables.erase(form.tables.begin());
    form.terms[0].factors = {{0, std::vector<Angle>{Angle::theta_i, Angle::theta_o}}};
    return form;
}

Form formPqp2001(int size)
{
    Form form = formPqp(size, 1.0);
    form.name = "pqp-2001";
    return form;
}

/// A form that stands alone or as a term of a sum: its sizes from the smallest to the one it has by
/// default.
struct BaseForm {
    NamedForm named;
    std::vector<Form> ladder;
    std::function<Form(int)> make;
};

const std::vector<BaseForm>& baseForms()
{
    const auto pqp = [](int n) { return formPqp(n, kGamma); };
    const auto pqpr = [](int n) { return formPqpr(n, kGamma, kKnots); };
    const auto pqp2001 = [](int n) { return formPqp2001(n); };
    const auto hdio = [](int n) { return formHdio(n, std::max(4, n / 4), std::max(4, n / 4)); };
    static const std::vector<BaseForm> forms{
        {{"pqp", "p(wo) q(h) p(wi)",
          "anisotropic, reciprocal; N + 1 passes of at most two look-ups", 32},
         {pqp(8), pqp(12), pqp(16), pqp(24), pqp(32)},
         pqp},
        {{"pqp-2001", "p(wo) q(h) p(wi)",
          "the maps of 2001, without the warp that spends texels on the highlight", 32},
         {pqp2001(16), pqp2001(32)},
         pqp2001},
        {{"pqpr", "p(wo) q(h) p(wi) r(theta_d)",
          "as pqp; r is a uniform array and costs no look-up", 32},
         {pqpr(8), pqpr(12), pqpr(16), pqpr(24), pqpr(32)},
         pqpr},
        {{"hdio", "T1(theta_h, theta_d) T2(theta_i, theta_o)",
          "isotropic, reciprocal; N passes of two look-ups", 64},
         {hdio(16), hdio(24), hdio(32), formHdio(48, 8, 8), hdio(48), hdio(64)},
         hdio},
        {{"io", "T(theta_i, theta_o)",
          "diffuse, isotropic, reciprocal; one look-up; a term of sums", 16},
         {formIo(4), formIo(8), formIo(12), formIo(16)},
         formIo},
    };
    return forms;
}

const BaseForm& baseForm(const std::string& name)
{
    for (const BaseForm& base : baseForms())
        if (base.named.name == name) return base;
    std::string known;
    for (const BaseForm& base : baseForms()) known += ", " + base.named.name;
    throw Error(
        ErrorKind::usage, "form",
        "found '" + name + "', expected auto" + known + ", or a sum of them such as io+hdio");
}

std::vector<std::string> partsOf(const std::string& name)
{
    std::vector<std::string> parts;
    size_t from = 0;
    for (size_t plus = name.find('+'); plus != std::string::npos; plus = name.find('+', from)) {
        parts.push_back(name.substr(from, plus - from));
        from = plus + 1;
    }
    parts.push_back(name.substr(from));
    return parts;
}

// Tables of a later term get the term's number: T2 and T2.2 are two tables.
Form sumOf(const std::string& name, const std::vector<Form>& parts)
{
    Form sum = parts[0];
    sum.name = name;
    for (size_t p = 1; p < parts.size(); ++p) {
        const int shift = static_cast<int>(sum.tables.size());
        for (TableSpec spec : parts[p].tables) {
            spec.name += "." + std::to_string(p + 1);
            sum.tables.push_back(spec);
        }
        for (Term term : parts[p].terms) {
            for (Factor& factor : term.factors) factor.table += shift;
            sum.terms.push_back(term);
        }
    }
    return sum;
}

// The sizes of a sum climb together: step k of every part's ladder, the last step where a ladder
// ends.
Form ladderStep(const std::string& name, size_t step)
{
    std::vector<Form> parts;
    for (const std::string& part : partsOf(name)) {
        const auto& ladder = baseForm(part).ladder;
        parts.push_back(ladder[std::min(step, ladder.size() - 1)]);
    }
    return sumOf(name, parts);
}

size_t ladderSteps(const std::string& name)
{
    size_t steps = 0;
    for (const std::string& part : partsOf(name))
        steps = std::max(steps, baseForm(part).ladder.size());
    return steps;
}

// Texels that samples decide: those of uniform tables and the mirrored half of symmetric ones
// included, which is near enough for a rule of thumb.
size_t texelsOf(const Form& form)
{
    size_t texels = 0;
    for (const TableSpec& spec : form.tables)
        texels += static_cast<size_t>(texelCount(spec.domain));
    return texels;
}

}  // namespace

const std::vector<NamedForm>& namedForms()
{
    static const std::vector<NamedForm> forms = [] {
        std::vector<NamedForm> named;
        for (const BaseForm& base : baseForms()) named.push_back(base.named);
        return named;
    }();
    return forms;
}

Form makeForm(const std::string& name, int resolution)
{
    if (resolution == 0) return ladderStep(name, ladderSteps(name));
    if (resolution < kMinResolution || resolution > kMaxResolution)
        throw Error(ErrorKind::usage, "resolution",
                    "found " + std::to_string(resolution) + ", expected " +
                        std::to_string(kMinResolution) + " to " + std::to_string(kMaxResolution));
    std::vector<Form> parts;
    for (const std::string& part : partsOf(name)) {
        const BaseForm& base = baseForm(part);
        parts.push_back(
            base.make(part == "io" ? std::max(kMinResolution, resolution / 4) : resolution));
    }
    return sumOf(name, parts);
}

size_t formBytes(const Form& form, Storage storage)
{
    return texelsOf(form) * 3 * static_cast<size_t>(bytesPerChannel(storage));
}

Form makeFormFor(const std::string& name, size_t samples, size_t maxBytes, Storage storage)
{
    constexpr size_t kSamplesPerTexel = 6;
    size_t best = 0;
    for (size_t step = 0; step < ladderSteps(name); ++step) {
        const Form form = ladderStep(name, step);
        if (maxBytes > 0 && formBytes(form, storage) > maxBytes) break;
        if (step > 0 && texelsOf(form) * kSamplesPerTexel > samples) break;
        best = step;
    }
    Form form = ladderStep(name, best);
    if (maxBytes > 0 && formBytes(form, storage) > maxBytes)
        throw Error(ErrorKind::usage, "max-bytes",
                    "found " + std::to_string(maxBytes) + ", expected at least " +
                        std::to_string(formBytes(form, storage)) + " for " + name);
    return form;
}

int lookupsPerLight(const Form& form)
{
    int lookups = 0;
    for (const Term& term : form.terms)
        for (const Factor& factor : term.factors)
            if (!form.tables[static_cast<size_t>(factor.table)].uniform && dependsOnLight(factor))
                ++lookups;
    return lookups;
}

}  // namespace fbrdf
