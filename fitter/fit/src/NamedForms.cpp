#include "NamedForms.h"

#include <fbrdf/brdf/Error.h>
#include <fbrdf/fit/Svd.h>

#include <algorithm>
#include <functional>

namespace fbrdf {
namespace {

constexpr double kGamma = 0.5;  // the warp that spends texels on the highlight
constexpr int kKnots = 24;      // of r(theta_d) and g(theta)
constexpr int kMinResolution = 4, kMaxResolution = 256;

const AxisMap kHalfAxis{AxisMap::From::oneMinusCosine, 0.25},
    kDifferenceAxis{AxisMap::From::oneMinusCosine, 0.5}, kGrazingAxis{AxisMap::From::cosine, 0.5};

using Angles = std::vector<Angle>;

int quarter(int size)
{
    return std::max(kMinResolution, size / 4);
}

// Tables that several forms are made of.
TableSpec discMap(const std::string& name, int size)
{
    return {name, DiscDomain::fitting(size, kGamma)};
}

TableSpec curve(const std::string& name, const AxisMap& map)
{
    return {name, GridDomain{{{kKnots, map}}}, true};
}

TableSpec zenithPair(const std::string& name, int size)
{
    return {name, GridDomain{{{size, kGrazingAxis}, {size, kGrazingAxis}}, true}};
}

const Angles kThetaD{Angle::theta_d}, kThetaI{Angle::theta_i}, kThetaO{Angle::theta_o},
    kThetaIO{Angle::theta_i, Angle::theta_o};

Form formIo(int size)
{
    return {"io", {zenithPair("T2", size)}, {{{{0, kThetaIO}}}}};
}

Form formGg(int)
{
    return {"gg", {curve("g", kGrazingAxis)}, {{{{0, kThetaO}, {0, kThetaI}}}}};
}

Form formHdg(int size)
{
    Form form = formHdio(size, quarter(size), 2);
    form.name = "hdg";
    form.tables[1] = curve("g", kGrazingAxis);
    form.terms[0].factors = {form.terms[0].factors[0], {1, kThetaO}, {1, kThetaI}};
    return form;
}

Form formPqp2001(int size)
{
    Form form = formPqp(size, 1.0);
    form.name = "pqp-2001";
    return form;
}

Form formHdp(int size)
{
    const int side = quarter(size);
    return {"hdp",
            {{"V", GridDomain{{{size, kHalfAxis},
                               {side, kDifferenceAxis},
                               {side, {AxisMap::From::oneMinusCosine, 0.5}}}}}},
            {{{{0, Angles{Angle::theta_h, Angle::theta_d, Angle::phi_d}}}}}};
}

// Near the highlight theta_i and theta_o hardly tell phi_d, and a table over phi_d alone hardly
// tells shadowing: together they hold what hdio and hdp each lose. Two knots of phi_d are enough,
// as the dependence is close to one harmonic. The exponents are the best of 0.18 to 0.28 and 0.5
// to 0.9 for measured materials.
Form formHdpio(int sizeH, int sizeD, int sizeIo)
{
    return {"hdpio",
            {{"V", GridDomain{{{sizeH, {AxisMap::From::oneMinusCosine, 0.22}},
                               {sizeD, {AxisMap::From::oneMinusCosine, 0.7}},
                               {2, {AxisMap::From::oneMinusCosine, 0.5}}}}},
             zenithPair("T2", sizeIo)},
            {{{{0, Angles{Angle::theta_h, Angle::theta_d, Angle::phi_d}}, {1, kThetaIO}}}}};
}

Form formQdg(int size)
{
    return {"qdg",
            {discMap("q", size), curve("r", kDifferenceAxis), curve("g", kGrazingAxis)},
            {{{{0, Direction::h}, {1, kThetaD}, {2, kThetaO}, {2, kThetaI}}}}};
}

Form formQdio(int size)
{
    return {"qdio",
            {discMap("q", size), curve("r", kDifferenceAxis), zenithPair("T2", quarter(size))},
            {{{{0, Direction::h}, {1, kThetaD}, {2, kThetaIO}}}}};
}

// p and q as in pqpr, and a table of their own for the light: nothing makes it reciprocal.
Form formPqtr(int size)
{
    Form form = formPqpr(size, kGamma, kKnots);
    form.name = "pqtr";
    form.tables.push_back(discMap("t", size));
    form.terms[0].factors[2].table = 3;
    return form;
}

Form withFactor(Form form, const std::string& name, const TableSpec& table,
                const Argument& argument)
{
    form.name = name;
    form.terms[0].factors.push_back({static_cast<int>(form.tables.size()), argument});
    form.tables.push_back(table);
    return form;
}

Form formPqpd(int size)
{
    return withFactor(formPqp(size, kGamma), "pqpd", discMap("s", size / 2), Direction::d);
}

Form formPqpn(int size)
{
    return withFactor(formPqpr(size, kGamma, kKnots), "pqpn", discMap("s", size / 2),
                      Direction::combination(1, 1, 1));
}

/// A form that stands alone or as a term of a sum: its sizes from the smallest to the one it has by
/// default.
struct BaseForm {
    NamedForm named;
    std::vector<Form> ladder;
    std::function<Form(int)> make;
};

std::vector<Form> ladderOf(const std::function<Form(int)>& make, const std::vector<int>& sizes)
{
    std::vector<Form> ladder;
    for (const int size : sizes) ladder.push_back(make(size));
    return ladder;
}

BaseForm baseOf(const NamedForm& named, const std::function<Form(int)>& make)
{
    std::vector<int> sizes;
    for (const int size : {8, 12, 16, 24, 32, 48, 64})
        if (size < named.defaultResolution) sizes.push_back(size);
    sizes.push_back(named.defaultResolution);
    return {named, ladderOf(make, sizes), make};
}

// Of these two the smaller sizes are not the default's in proportion.
BaseForm baseHdio()
{
    const auto make = [](int n) { return formHdio(n, quarter(n), quarter(n)); };
    return {{"hdio", "T1(theta_h, theta_d) T2(theta_i, theta_o)",
             "isotropic, reciprocal; N passes of two look-ups", 64},
            {make(16), make(24), make(32), formHdio(48, 8, 8), make(48), make(64)},
            make};
}

BaseForm baseHdpio()
{
    return {{"hdpio", "V(theta_h, theta_d, phi_d) T2(theta_i, theta_o)",
             "isotropic, reciprocal; hdio that sees phi_d: N passes of two look-ups", 48},
            {formHdpio(16, 4, 6), formHdpio(24, 5, 8), formHdpio(32, 6, 8), formHdpio(40, 9, 10),
             formHdpio(48, 12, 12)},
            [](int n) { return formHdpio(n, quarter(n), quarter(n)); }};
}

std::vector<BaseForm> makeBaseForms()
{
    const auto pqp = [](int n) { return formPqp(n, kGamma); };
    // p is smooth: texels beyond 32 x 32 are worth more in q.
    const auto pqpr = [](int n) {
        Form form = formPqpr(n, kGamma, kKnots);
        form.tables[0].domain = DiscDomain::fitting(std::min(n, 32), kGamma);
        return form;
    };
    return {
        baseOf({"pqp", "p(wo) q(h) p(wi)",
                "anisotropic, reciprocal; N + 1 passes of at most two look-ups", 32},
               pqp),
        baseOf({"pqpr", "p(wo) q(h) p(wi) r(theta_d)",
                "as pqp; r is a uniform array and costs no look-up", 32},
               pqpr),
        baseHdio(),
        baseOf({"hdg", "T1(theta_h, theta_d) g(theta_i) g(theta_o)",
                "isotropic, reciprocal; g is a uniform array: N passes of one look-up", 64},
               formHdg),
        baseOf({"hdp", "V(theta_h, theta_d, phi_d)",
                "isotropic, reciprocal; one 3D table: N passes of one look-up", 32},
               formHdp),
        baseHdpio(),
        baseOf({"qdio", "q(h) r(theta_d) T2(theta_i, theta_o)",
                "anisotropic in h alone, reciprocal; N passes of two look-ups", 32},
               formQdio),
        baseOf({"qdg", "q(h) r(theta_d) g(theta_i) g(theta_o)",
                "as qdio with r and g in uniform arrays: N passes of one look-up", 32},
               formQdg),
        baseOf(
            {"pqtr", "p(wo) q(h) t(wi) r(theta_d)",
             "as pqpr with maps of their own for wo and wi: for data that is not reciprocal", 32},
            formPqtr),
        baseOf({"pqpd", "p(wo) q(h) p(wi) s(d)",
                "as pqp with a map over the difference direction: three look-ups", 32},
               formPqpd),
        baseOf({"pqpn", "p(wo) q(h) p(wi) r(theta_d) s(norm(wi + wo + n))",
                "as pqpr with a map over a broader half vector: three look-ups", 32},
               formPqpn),
        baseOf({"pqp-2001", "p(wo) q(h) p(wi)",
                "the maps of 2001, without the warp that spends texels on the highlight", 32},
               formPqp2001),
        {{"io", "T2(theta_i, theta_o)",
          "diffuse, isotropic, reciprocal; one look-up; a term of sums", 16},
         ladderOf(formIo, {4, 8, 12, 16}),
         formIo},
        {{"gg", "g(theta_i) g(theta_o)", "as io in a uniform array: no look-up; a term of sums",
          kKnots},
         {formGg(kKnots)},
         formGg},
    };
}

const std::vector<BaseForm>& baseForms()
{
    static const std::vector<BaseForm> forms = makeBaseForms();
    return forms;
}

const BaseForm& baseForm(const std::string& name)
{
    for (const BaseForm& base : baseForms())
        if (base.named.name == name) return base;
    std::string known;
    for (const BaseForm& base : baseForms()) known += ", " + base.named.name;
    for (const NamedForm& made : madeForms()) known += ", " + made.name;
    throw Error(ErrorKind::usage, "form",
                "found '" + name + "', expected auto" + known + ", or a sum such as io+hdio");
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

const std::vector<NamedForm>& madeForms()
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
        parts.push_back(base.make(part == "io" ? quarter(resolution) : resolution));
    }
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
    throw Error(ErrorKind::usage, "max-bytes",
                "found " + std::to_string(maxBytes) + ", expected at least " +
                    std::to_string(formBytes(ladderStep(name, 0), storage)) + " for " + name);
}

}  // namespace fbrdf
