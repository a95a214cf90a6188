// FormTest.cpp - forms as data: the named ones, their descriptions, and every way to be invalid.
#include <fbrdf/base/Error.h>
#include <fbrdf/brdf/Form.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace fbrdf;

namespace {

TEST(Form, NamedFormsAreValidAndDescribeThemselves)
{
    EXPECT_EQ(describe(formPqp(32, 0.5)),
              "p[disc 32x32 gamma 0.5](wo) q[disc 32x32 gamma 0.5](h) p(wi)");
    EXPECT_EQ(
        describe(formPqpr(16, 1.0, 24)),
        "p[disc 16x16 gamma 1](wo) q[disc 16x16 gamma 1](h) p(wi) r[24 (1-cos)^0.5](theta_d)");
    const std::string hdio = describe(formHdio({48, 8, 12}));
    EXPECT_EQ(hdio.substr(0, 54), "T1[48 (1-cos)^0.25 x 8 (1-cos)^0.5](theta_h, theta_d) ");
    EXPECT_NE(hdio.find("symmetric](theta_i, theta_o)"), std::string::npos) << hdio;
    for (const Form& form : {formPqp(32, 0.5), formPqpr(16, 1.0, 24), formHdio({48, 8, 12})})
        EXPECT_NO_THROW(validate(form, "form"));
    EXPECT_TRUE(formPqpr(16, 1.0, 24).tables[2].uniform);
}

TEST(Form, SumsAreDescribedTermByTerm)
{
    Form form = formPqp(8, 1.0);
    form.terms.push_back({{{1, Direction::h}}});
    EXPECT_EQ(describe(form), "p[disc 8x8 gamma 1](wo) q[disc 8x8 gamma 1](h) p(wi) + q(h)");
}

TEST(Form, KnowsWhatIsIsotropicAndWhatDependsOnTheLight)
{
    EXPECT_TRUE(isIsotropic(formHdio({8, 4, 4})));
    EXPECT_FALSE(isIsotropic(formPqp(8, 1.0)));
    EXPECT_FALSE(dependsOnLight({0, Direction::wo}));
    EXPECT_TRUE(dependsOnLight({0, Direction::h}));
    EXPECT_TRUE(dependsOnLight({0, Direction::wi}));
    EXPECT_TRUE(dependsOnLight({0, Direction::d}));
    EXPECT_FALSE(dependsOnLight({0, Direction::mirror}));
    EXPECT_TRUE(dependsOnLight({0, Direction::combination(1.0, 0.1, 0.0)}));
    EXPECT_FALSE(dependsOnLight({0, Direction::combination(1.0, 0.0, 3.0)}));
    EXPECT_FALSE(dependsOnLight({0, std::vector<Angle>{Angle::theta_o}}));
    EXPECT_TRUE(dependsOnLight({0, std::vector<Angle>{Angle::theta_o, Angle::theta_i}}));
    EXPECT_TRUE(dependsOnLight({0, std::vector<Angle>{Angle::theta_d}}));
}

TEST(Form, NamesOfDirectionsAndAnglesDiffer)
{
    EXPECT_EQ(directionName(Direction::wi), "wi");
    EXPECT_EQ(directionName(Direction::wo), "wo");
    EXPECT_EQ(directionName(Direction::h), "h");
    EXPECT_EQ(directionName(Direction::d), "d");
    EXPECT_EQ(directionName(Direction::mirror), "mirror");
    EXPECT_EQ(directionName(Direction::combination(1.0, 1.0, 0.0)), "h");
    EXPECT_EQ(directionName(Direction::combination(1.0, 0.5, -2.0)), "norm(0.5 wi + 1 wo + -2 n)");
    EXPECT_STREQ(angleName(Angle::theta_h), "theta_h");
    EXPECT_STREQ(angleName(Angle::theta_d), "theta_d");
    EXPECT_STREQ(angleName(Angle::theta_i), "theta_i");
    EXPECT_STREQ(angleName(Angle::theta_o), "theta_o");
    EXPECT_STREQ(angleName(Angle::phi_d), "phi_d");
    EXPECT_STREQ(angleName(Angle::half_phi_d), "half_phi_d");
    EXPECT_STREQ(angleName(Angle::side_phi_d), "side_phi_d");
}

struct Fault {
    const char* words;
    std::function<void(Form&)> make;
};

DiscDomain& disc(Form& form)
{
    return std::get<DiscDomain>(form.tables[0].domain);
}

GridDomain& grid(Form& form)
{
    return std::get<GridDomain>(form.tables[2].domain);
}

void expectFaults(const Form& valid, const std::vector<Fault>& faults)
{
    for (const Fault& fault : faults) {
        Form form = valid;
        fault.make(form);
        try {
            validate(form, "here");
            ADD_FAILURE() << "accepted; expected an error with the words: " << fault.words;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::input);
            const std::string what = error.what();
            EXPECT_EQ(what.rfind("here: ", 0), 0u) << what;
            EXPECT_NE(what.find(fault.words), std::string::npos) << what << "\n  " << fault.words;
        }
    }
}

TEST(Form, RefusesInvalidDiscs)
{
    expectFaults(formPqpr(8, 1.0, 5),
                 {{"disc map of 1 texels", [](Form& f) { disc(f).size = 1; }},
                  {"disc map of 4097 texels", [](Form& f) { disc(f).size = 4097; }},
                  {"disc map of -2147483648", [](Form& f) { disc(f).size = INT32_MIN; }},
                  {"gamma 0", [](Form& f) { disc(f).gamma = 0.0; }},
                  {"gamma 17", [](Form& f) { disc(f).gamma = 17.0; }},
                  {"gamma nan", [](Form& f) { disc(f).gamma = std::nan(""); }},
                  {"disc radius 0", [](Form& f) { disc(f).radius = 0.0; }},
                  {"disc radius 3.6", [](Form& f) { disc(f).radius = 3.6; }},
                  {"disc radius nan", [](Form& f) { disc(f).radius = std::nan(""); }},
                  {"table 'p'", [](Form& f) { disc(f).radius = 4.0; }},
                  {"uniform", [](Form& f) { f.tables[0].uniform = true; }}});
}

TEST(Form, RefusesInvalidGrids)
{
    const Axis axis{5, {}}, large{4096, {}};
    expectFaults(
        formPqpr(8, 1.0, 5),
        {{"0 axes", [](Form& f) { grid(f).axes.clear(); }},
         {"4 axes", [&](Form& f) { grid(f).axes.assign(4, axis); }},
         {"axis of 0 knots", [](Form& f) { grid(f).axes[0].size = 0; }},
         {"axis of 4097 knots", [](Form& f) { grid(f).axes[0].size = 4097; }},
         {"axis exponent 0", [](Form& f) { grid(f).axes[0].map.exponent = 0.0; }},
         {"axis exponent 16.5", [](Form& f) { grid(f).axes[0].map.exponent = 16.5; }},
         {"axis exponent nan", [](Form& f) { grid(f).axes[0].map.exponent = std::nan(""); }},
         {"expected at most 2^24", [&](Form& f) { grid(f).axes.assign(3, large); }},
         {"symmetric", [](Form& f) { grid(f).symmetric = true; }},
         {"uniform", [&](Form& f) { grid(f).axes.assign(2, axis); }},
         {"uniform", [](Form& f) { grid(f).axes[0].size = 65; }}});
    Form unequal = formHdio({8, 4, 4});
    std::get<GridDomain>(unequal.tables[1].domain).axes[1].map.exponent = 0.75;
    EXPECT_THROW(validate(unequal, "here"), Error);
}

TEST(Form, RefusesInvalidTerms)
{
    expectFaults(
        formPqpr(8, 1.0, 5),
        {{"0 tables", [](Form& f) { f.tables.clear(); }},
         {"65 tables", [](Form& f) { f.tables.resize(65, f.tables[0]); }},
         {"0 terms", [](Form& f) { f.terms.clear(); }},
         {"65 terms", [](Form& f) { f.terms.resize(65, f.terms[0]); }},
         {"without factors", [](Form& f) { f.terms[0].factors.clear(); }},
         {"a term of 65 factors",
          [](Form& f) { f.terms[0].factors.resize(65, f.terms[0].factors[0]); }},
         {"table index 3", [](Form& f) { f.terms[0].factors[0].table = 3; }},
         {"direction weight nan",
          [](Form& f) {
              f.terms[0].factors[0].argument = Direction::combination(1.0, std::nan(""), 0.0);
          }},
         {"direction weight 2000",
          [](Form& f) {
              f.terms[0].factors[0].argument = Direction::combination(1.0, 0.0, 2000.0);
          }},
         {"table index -1", [](Form& f) { f.terms[0].factors[0].table = -1; }},
         {"looked up with (wi)", [](Form& f) { f.terms[0].factors[3].argument = Direction::wi; }},
         {"looked up with (theta_d)",
          [](Form& f) { f.terms[0].factors[0].argument = f.terms[0].factors[3].argument; }},
         {"one angle an axis", [](Form& f) {
              f.terms[0].factors[3].argument = std::vector<Angle>{Angle::theta_d, Angle::theta_h};
          }}});
}

}  // namespace
