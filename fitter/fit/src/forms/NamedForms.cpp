#include "forms/NamedForms.h"

#include "forms/BaseForms.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/fit/Svd.h>

#include <algorithm>

namespace fbrdf {
namespace {

const BaseForm& baseForm(const std::string& name)
{
    for (const BaseForm& base : baseForms())
        if (base.named.name == name) return base;
    std::string known;
    for (const BaseForm& base : baseForms()) known += ", " + base.named.name;
    for (const NamedForm& direct : directForms()) known += ", " + direct.name;
    throw Error(ErrorKind::usage, "form",
                Found("'" + name + "'").expected("auto" + known + ", or a sum such as io+hdio"));
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

const std::vector<NamedForm>& directForms()
{
    static const std::vector<NamedForm> forms{
        {"svd", "sum over k of u_k(h) v_k(d)",
         "the baseline of singular values: signed half floats, two look-ups a term; svdN: N terms",
         kSvdSize},
        {"analytic", "by the model: p(wo) q(h) p(wi) + D",
         "factors written down, no fit: models ward (one look-up) and ashikhmin-shirley (two)",
         64}};
    return forms;
}

const std::vector<FormLetter>& formLetters()
{
    static const std::vector<FormLetter> letters{
        {"p", "a map over wo, used again over wi; after hd: the angle phi_d"},
        {"q", "a map over the half vector h"},
        {"r", "an array over theta_d"},
        {"t", "a map over wi of its own, where p is over wo alone"},
        {"h", "theta_h, the angle between normal and half vector"},
        {"d",
         "theta_d, the angle between light and half vector; after pqp: a map over the "
         "difference vector d"},
        {"io",
         "a table over theta_i and theta_o, the angles of light and view, that stays the same "
         "when these change places"},
        {"u", "a table over theta_i and theta_o that does not"},
        {"s", "after hd: half of the angle phi_d, which tells light from view"},
        {"a",
         "after hd: half of the angle phi_d, which tells the sides of the plane of incidence "
         "apart"},
        {"g", "an array over theta_o, used again over theta_i"},
        {"n", "a map over wi + wo + n, a half vector drawn towards the normal n"},
        {"+", "a sum of terms"},
    };
    return letters;
}

Form makeForm(const std::string& name, int resolution)
{
    if (resolution == 0) return ladderStep(name, ladderSteps(name));
    if (resolution < kMinResolution || resolution > kMaxResolution)
        throw Error(ErrorKind::usage, "resolution",
                    Found(std::to_string(resolution))
                        .expected(std::to_string(kMinResolution) + " to " +
                                  std::to_string(kMaxResolution)));
    std::vector<Form> parts;
    for (const std::string& part : partsOf(name)) parts.push_back(baseForm(part).make(resolution));
    return sumOf(name, parts);
}

size_t formTexels(const Form& form)
{
    size_t texels = 0;
    for (const TableSpec& spec : form.tables)
        texels += static_cast<size_t>(texelCount(spec.domain));
    return texels;
}

size_t formBytes(const Form& form, Storage storage)
{
    return formTexels(form) * 3 * static_cast<size_t>(bytesPerChannel(storage));
}

std::optional<Form> largestFormFor(const std::string& name, size_t samples, size_t maxBytes,
                                   Storage storage)
{
    std::optional<Form> largest;
    for (size_t step = 0; step < ladderSteps(name); ++step) {
        const Form form = ladderStep(name, step);
        if (maxBytes > 0 && formBytes(form, storage) > maxBytes) break;
        if (step > 0 && formTexels(form) * kSamplesPerTexel > samples) break;
        largest = form;
    }
    return largest;
}

Form makeFormFor(const std::string& name, size_t samples, size_t maxBytes, Storage storage)
{
    if (const auto form = largestFormFor(name, samples, maxBytes, storage)) return *form;
    throw Error(
        ErrorKind::usage, "max-bytes",
        Found(std::to_string(maxBytes))
            .expected("at least " + std::to_string(formBytes(ladderStep(name, 0), storage)) +
                      " for " + name));
}

}  // namespace fbrdf
