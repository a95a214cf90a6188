#include "forms/BaseForms.h"

#include <algorithm>

namespace fbrdf {
namespace {

constexpr double kGamma = 0.5;  // the warp that spends texels on the highlight
constexpr int kKnots = 24;      // of r(theta_d) and g(theta)

const AxisMap kHalfAxis{AxisMap::From::oneMinusCosine, 0.25},
    kDifferenceAxis{AxisMap::From::oneMinusCosine, 0.5}, kGrazingAxis{AxisMap::From::cosine, 0.5};

using Angles = std::vector<Angle>;

int quarter(int size)
{
    return std::max(kMinResolution, size / 4);
}

// The tables that several forms share.
TableSpec discMap(const std::string& name, int size)
{
    return {name, DiscDomain::fitting(size, kGamma)};
}

TableSpec curve(const std::string& name, const AxisMap& map, int knots = kKnots)
{
    return {name, GridDomain{{{knots, map}}}, true};
}

// Scattered samples that few texels of T1 are for lie on few angles of light and view; between
// those, knots of g that none of them holds rise and fall with the opposite of T1.
int knotsBeside(int size)
{
    return size < 32 ? std::max(8, size / 2) : kKnots;
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

Form formGg(int size)
{
    return {"gg", {curve("g", kGrazingAxis, knotsBeside(size))}, {{{{0, kThetaO}, {0, kThetaI}}}}};
}

Form formHdg(int size)
{
    HdioSizes sizes;
    sizes.h = size, sizes.d = quarter(size);
    Form form = formHdio(sizes);
    form.name = "hdg";
    form.tables[1] = curve("g", kGrazingAxis, knotsBeside(size));
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

// Near the highlight theta_i and theta_o hardly depend on phi_d, and a table over phi_d alone
// cannot represent shadowing: the two tables together represent what hdio and hdp each lose. Two
// knots of phi_d are enough, as the dependence is close to one harmonic. The exponents are the best
// of 0.18 to 0.28 and 0.5 to 0.9 for measured materials.
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

// A table U that distinguishes light from view, in place of the symmetric T2: measurements and
// networks are seldom reciprocal.
Form unsymmetric(Form form, const std::string& name)
{
    form.name = name;
    TableSpec& table = form.tables.back();
    table.name = "U";
    std::get<GridDomain>(table.domain).symmetric = false;
    return form;
}

Form formU(int size)
{
    return unsymmetric(formIo(size), "u");
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

// hdio and hdpio list their smaller sizes explicitly: they do not scale in proportion.
BaseForm baseHdio()
{
    const auto make = [](int n) {
        HdioSizes sizes;
        sizes.h = n, sizes.d = sizes.io = quarter(n);
        return formHdio(sizes);
    };
    HdioSizes fewAngles;
    fewAngles.h = 48, fewAngles.d = fewAngles.io = 8;
    return {{"hdio", "T1(theta_h, theta_d) T2(theta_i, theta_o)",
             "isotropic, reciprocal; N passes of two look-ups", 64, true},
            {make(16), make(24), make(32), formHdio(fewAngles), make(48), make(64)},
            make};
}

BaseForm baseHdpio()
{
    return {{"hdpio", "V(theta_h, theta_d, phi_d) T2(theta_i, theta_o)",
             "isotropic, reciprocal; hdio that sees phi_d: N passes of two look-ups", 48, true},
            {formHdpio(16, 4, 6), formHdpio(24, 5, 8), formHdpio(32, 6, 8), formHdpio(40, 9, 10),
             formHdpio(48, 12, 12)},
            [](int n) { return formHdpio(n, quarter(n), quarter(n)); }};
}

// Data that are not reciprocal gain enough to pay for more knots of phi_d and of U.
Form formHdpu(int size)
{
    Form form = formHdpio(size, std::max(kMinResolution, 5 * size / 16),
                          std::max(kMinResolution, size / 3));
    std::get<GridDomain>(form.tables[0].domain).axes[2].size = std::max(2, size / 16);
    return unsymmetric(form, "hdpu");
}

BaseForm baseHdpu()
{
    std::vector<Form> ladder = baseHdpio().ladder;
    for (Form& form : ladder) form = unsymmetric(form, "hdpu");
    ladder.push_back(formHdpu(48));
    return {{"hdpu", "V(theta_h, theta_d, phi_d) U(theta_i, theta_o)",
             "as hdpio with U not symmetric: for isotropic data that is not reciprocal", 48},
            ladder,
            formHdpu};
}

// Files that interpolate between few slices of theta_i are not reciprocal about highlights at low
// angles: there light and view must be told apart beside the highlight, which U cannot.
Form formWithHalf(const char* name, Angle half, int size)
{
    const auto axis = [](int knots, double exponent) {
        return Axis{std::max(kMinResolution, knots), {AxisMap::From::oneMinusCosine, exponent}};
    };
    const GridDomain grid{{axis(size, 0.22), axis(9 * size / 32, 0.7), axis(size / 4, 0.5)}};
    const Form form{name,
                    {{"V", grid}, zenithPair("U", std::max(kMinResolution, size / 2))},
                    {{{{0, Angles{Angle::theta_h, Angle::theta_d, half}}, {1, kThetaIO}}}}};
    return unsymmetric(form, name);
}

Form formHdsu(int size)
{
    return formWithHalf("hdsu", Angle::half_phi_d, size);
}

// MERL's samples differ between the two sides of the plane of incidence where a coat of grease has
// run, or a ball was brushed.
Form formHdau(int size)
{
    return formWithHalf("hdau", Angle::side_phi_d, size);
}

BaseForm baseHdsu()
{
    return baseOf({"hdsu", "V(theta_h, theta_d, half_phi_d) U(theta_i, theta_o)",
                   "as hdpu with phi_d over half a turn, which tells light from view", 32},
                  formHdsu);
}

BaseForm baseHdau()
{
    return baseOf(
        {"hdau", "V(theta_h, theta_d, side_phi_d) U(theta_i, theta_o)",
         "as hdpu with phi_d over half a turn, which tells the sides of incidence apart", 32},
        formHdau);
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
                "anisotropic, reciprocal; N + 1 passes of at most two look-ups", 32, true},
               pqp),
        baseOf({"pqpr", "p(wo) q(h) p(wi) r(theta_d)",
                "as pqp; r is a uniform array and costs no look-up", 32, true},
               pqpr),
        baseHdio(),
        baseOf({"hdg", "T1(theta_h, theta_d) g(theta_i) g(theta_o)",
                "isotropic, reciprocal; g is a uniform array: N passes of one look-up", 64, true},
               formHdg),
        baseOf({"hdp", "V(theta_h, theta_d, phi_d)",
                "isotropic, reciprocal; one 3D table: N passes of one look-up", 32, true},
               formHdp),
        baseHdpio(),
        baseHdpu(),
        baseHdsu(),
        baseHdau(),
        baseOf({"qdio", "q(h) r(theta_d) T2(theta_i, theta_o)",
                "anisotropic in h alone, reciprocal; N passes of two look-ups", 32, true},
               formQdio),
        baseOf({"qdg", "q(h) r(theta_d) g(theta_i) g(theta_o)",
                "as qdio with r and g in uniform arrays: N passes of one look-up", 32, true},
               formQdg),
        baseOf(
            {"pqtr", "p(wo) q(h) t(wi) r(theta_d)",
             "as pqpr with maps of their own for wo and wi: for data that is not reciprocal", 32},
            formPqtr),
        baseOf({"pqpd", "p(wo) q(h) p(wi) s(d)",
                "as pqp with a map over the difference direction: three look-ups", 32},
               formPqpd),
        baseOf({"pqpn", "p(wo) q(h) p(wi) r(theta_d) s(norm(wi + wo + n))",
                "as pqpr with a map over a broader half vector: three look-ups", 32, true},
               formPqpn),
        baseOf({"pqp-2001", "p(wo) q(h) p(wi)",
                "the maps of 2001, without the warp that spends texels on the highlight", 32, true},
               formPqp2001),
        {{"io", "T2(theta_i, theta_o)",
          "diffuse, isotropic, reciprocal; one look-up; a term of sums", 16, true},
         ladderOf(formIo, {4, 8, 12, 16}),
         [](int n) { return formIo(quarter(n)); }},
        {{"u", "U(theta_i, theta_o)", "as io and not symmetric; one look-up; a term of sums", 16},
         ladderOf(formU, {4, 8, 12, 16}),
         [](int n) { return formU(quarter(n)); }},
        {{"gg", "g(theta_i) g(theta_o)", "as io in a uniform array: no look-up; a term of sums",
          kKnots, true},
         ladderOf(formGg, {8, 12, 16, 24, 32}),
         formGg},
    };
}

}  // namespace

const std::vector<BaseForm>& baseForms()
{
    static const std::vector<BaseForm> forms = makeBaseForms();
    return forms;
}

}  // namespace fbrdf
