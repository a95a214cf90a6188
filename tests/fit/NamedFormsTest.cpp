#include "forms/NamedForms.h"

#include <fbrdf/base/Error.h>

#include <gtest/gtest.h>

namespace fbrdf {
namespace {

TEST(NamedForms, EachIsValidAtItsDefaultSize)
{
    for (const NamedForm& named : namedForms()) {
        const Form form = makeForm(named.name);
        EXPECT_NO_THROW(validate(form, named.name));
        EXPECT_EQ(form.name, named.name);
        EXPECT_EQ(domainSize(form.tables[0].domain)[0], named.defaultResolution) << named.name;
    }
}

TEST(NamedForms, HdioHasTheSizesOfTheBudgets)
{
    EXPECT_EQ(formBytes(makeForm("hdio"), Storage::log8), 3840u);
    EXPECT_EQ(formBytes(makeFormFor("hdio", 1000000, 1400, Storage::log8), Storage::log8), 1344u);
    EXPECT_EQ(formBytes(makeForm("hdio"), Storage::half), 2u * 3840u);
}

TEST(NamedForms, HdpioFitsTheSameBudgets)
{
    EXPECT_EQ(formBytes(makeForm("hdpio"), Storage::log8), 3888u);
    EXPECT_EQ(formBytes(makeFormFor("hdpio", 1000000, 1400, Storage::log8), Storage::log8), 1344u);
    EXPECT_EQ(lookupsPerPass(makeForm("hdpio")), 2);
}

TEST(NamedForms, HdpuSeparatesLightFromViewInTheSameBytes)
{
    const Form form = makeFormFor("hdpu", 1000000, 3900, Storage::log8);
    EXPECT_EQ(formBytes(form, Storage::log8), 3888u);
    EXPECT_FALSE(std::get<GridDomain>(form.tables[1].domain).symmetric);
    EXPECT_EQ(lookupsPerPass(form), 2);
    EXPECT_TRUE(isIsotropic(form));
    const Form sum = makeFormFor("u+hdpu", 1000000, 8192, Storage::log8);
    EXPECT_EQ(formBytes(sum, Storage::log8), 8016u);
    EXPECT_EQ(lookupsPerLight(sum), 3);
    EXPECT_NO_THROW(validate(makeForm("u+hdpu", 5), "small"));
}

TEST(NamedForms, ASumHasTheTermsOfItsParts)
{
    const Form form = makeForm("io+pqpr");
    ASSERT_EQ(form.terms.size(), 2u);
    ASSERT_EQ(form.tables.size(), 4u);
    EXPECT_EQ(form.terms[1].factors[0].table, 1);
    EXPECT_NO_THROW(validate(form, "sum"));
    EXPECT_EQ(lookupsPerLight(form), 3);
}

TEST(NamedForms, FewSamplesGetSmallTables)
{
    EXPECT_LT(formBytes(makeFormFor("hdio", 1439, 0, Storage::log8), Storage::log8), 1000u);
    EXPECT_NO_THROW(makeFormFor("pqp", 1, 0, Storage::log8));
}

TEST(NamedForms, WhatDoesNotExistIsNamed)
{
    for (const std::string name : {"", "pqq", "hdio+", "+", "hdio+pqq"}) {
        try {
            makeForm(name);
            FAIL() << "'" << name << "' was taken";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::usage);
            EXPECT_NE(std::string(error.what()).find("expected auto, pqp"), std::string::npos)
                << error.what();
        }
    }
    EXPECT_THROW(makeForm("pqp", 3), Error);
    EXPECT_THROW(makeForm("pqp", 257), Error);
    EXPECT_THROW(makeFormFor("pqp", 1000, 10, Storage::log8), Error);
}

TEST(NamedForms, EveryLetterOfANameIsExplained)
{
    std::string known;
    for (const FormLetter& letter : formLetters()) {
        EXPECT_FALSE(letter.meaning.empty());
        known += letter.letters;
    }
    for (const NamedForm& named : namedForms())
        for (const char letter : named.name.substr(0, named.name.find('-')))
            EXPECT_NE(known.find(letter), std::string::npos) << letter << " of " << named.name;
}

}  // namespace
}  // namespace fbrdf
