// FormKeyTest.cpp - keys are equal for equal forms only. No GL.
#include <fbrdf/fit/FormKey.h>

#include <fbrdf/fit/Fit.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace fbrdf {
namespace {

TEST(FormKey, EveryNamedFormHasItsOwn)
{
    std::map<std::string, std::string> names;
    for (const NamedForm& named : namedForms())
        for (const int resolution : {16, 24}) {
            const Form form = makeForm(named.name, resolution);
            const auto [known, isNew] = names.emplace(formKey(form), named.name);
            // gg has one size.
            EXPECT_TRUE(isNew || known->second == named.name) << named.name;
        }
    EXPECT_GT(names.size(), namedForms().size());
}

TEST(FormKey, NamesDoNotCount)
{
    Form form = formPqp(12, 0.5);
    const std::string key = formKey(form);
    form.name = "mine";
    form.tables[0].name = "a";
    EXPECT_EQ(formKey(form), key);
}

class Change : public testing::TestWithParam<void (*)(Form&)> {};

TEST_P(Change, OfOneNumberGivesAnotherKey)
{
    Form form = makeForm("hdio+pqpr", 16);
    const std::string key = formKey(form);
    GetParam()(form);
    EXPECT_NE(formKey(form), key);
}

// The change that describe() does not show: the last digit.
void nudge(double& value)
{
    value = std::nextafter(value, 100.0);
}

GridDomain& grid(Form& form, size_t table)
{
    return std::get<GridDomain>(form.tables[table].domain);
}

DiscDomain& disc(Form& form, size_t table)
{
    return std::get<DiscDomain>(form.tables[table].domain);
}

Direction& direction(Form& form, size_t factor)
{
    return std::get<Direction>(form.terms[1].factors[factor].argument);
}

INSTANTIATE_TEST_SUITE_P(
    Fields, Change,
    testing::Values([](Form& form) { nudge(disc(form, 2).radius); },
                    [](Form& form) { nudge(disc(form, 2).gamma); },
                    [](Form& form) { ++disc(form, 3).size; },
                    [](Form& form) { nudge(grid(form, 0).axes[1].map.exponent); },
                    [](Form& form) { grid(form, 0).axes[0].map.from = AxisMap::From::cosine; },
                    [](Form& form) { ++grid(form, 0).axes[0].size; },
                    [](Form& form) { grid(form, 1).symmetric = false; },
                    [](Form& form) { form.tables[4].uniform = false; },
                    [](Form& form) { nudge(direction(form, 0).weight_n); },
                    [](Form& form) { direction(form, 1) = Direction::d; },
                    [](Form& form) { form.terms[1].factors[0].table = 3; },
                    [](Form& form) { form.terms[1].factors.pop_back(); },
                    [](Form& form) {
                        form.terms[0].factors.push_back(form.terms[1].factors[0]);
                        form.terms[1].factors.erase(form.terms[1].factors.begin());
                    }));

}  // namespace
}  // namespace fbrdf
