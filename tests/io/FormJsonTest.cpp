// FormJsonTest.cpp - forms are data: every valid one survives, every broken field is named.
#include "FormJson.h"

#include "io/TestMaterials.h"
#include "support/ExpectError.h"

#include <gtest/gtest.h>

using namespace fbrdf;
using fbrdf::test::expectError;

namespace {

Form reread(const Form& form)
{
    const Json json = parseJson(jsonFromForm(form).dump(), "text");
    return formFromJson(JsonField(json, "text"));
}

TEST(FormJson, RoundTripsEveryForm)
{
    for (const Form& form : test::testForms()) {
        const Form other = reread(form);
        EXPECT_EQ(other.name, form.name);
        EXPECT_EQ(describe(other), describe(form));
        ASSERT_EQ(other.tables.size(), form.tables.size());
        for (size_t k = 0; k < form.tables.size(); ++k) {
            EXPECT_EQ(other.tables[k].name, form.tables[k].name);
            EXPECT_EQ(other.tables[k].uniform, form.tables[k].uniform);
            EXPECT_TRUE(sameDomain(other.tables[k].domain, form.tables[k].domain));
        }
    }
}

TEST(FormJson, KeepsExponentsAndRadiiToTheLastBit)
{
    Form form = formPqp(12, 1.0 / 3.0);
    std::get<DiscDomain>(form.tables[0].domain).radius = 4.1234567890123456;
    EXPECT_TRUE(sameDomain(reread(form).tables[0].domain, form.tables[0].domain));
}

struct Damage {
    const char *pointer, *value, *says;
};

TEST(FormJson, NamesEveryBrokenField)
{
    const Damage damages[] = {
        {"/name", "7", "text/name: found 7, expected a string"},
        {"/tables", "{}", "text/tables: found an object of 0, expected an array"},
        {"/tables", "[]", "expected at least one table"},
        {"/tables/0/name", "null", "text/tables/0/name"},
        {"/tables/0/domain", "{}", "expected an object with 'grid'"},
        {"/tables/0/domain/disc/size", "3.5", "size: found 3.5, expected an integer"},
        {"/tables/0/domain/disc/size", "1", "disc map of 1 texels"},
        {"/tables/0/domain/disc/size", "1e99", "expected an integer"},
        {"/tables/0/domain/disc/size", "9999999999", "expected an integer"},
        {"/tables/0/domain/disc/size", "18446744073709551615", "expected an integer"},
        {"/tables/0/domain/disc/gamma", "\"a\"", "expected a finite number"},
        {"/tables/0/domain/disc/gamma", "-1", "gamma -1"},
        {"/tables/0/domain/disc/radius", "100", "disc radius 100"},
        {"/tables/2/uniform", "1", "expected true or false"},
        {"/tables/2/domain/grid/axes/0/from", "\"sin\"", "expected '1-cos' or 'cos'"},
        {"/tables/2/domain/grid/axes/0/exponent", "0", "axis exponent 0"},
        {"/tables/2/domain/grid/axes", "[1,2,3,4]", "expected 1 to 3 axes"},
        {"/terms", "[]", "0 terms, expected 1 to 64"},
        {"/terms/0", "[]", "a term without factors"},
        {"/terms/0/0/table", "3", "table: found 3, expected an index below 3"},
        {"/terms/0/0/table", "-1", "expected an index below 3"},
        {"/terms/0/0/argument", "\"n\"", "expected 'wi', 'wo', 'h', 'd', 'mirror' or"},
        {"/terms/0/0/argument", "[\"theta_h\"]", "expected a string"},
        {"/terms/0/3/argument", "[\"phi_h\"]", "expected 'theta_h', 'theta_d'"},
        {"/terms/0/3/argument", "[\"theta_h\",\"theta_d\"]", "expected one direction for a disc"},
    };
    const Json whole = jsonFromForm(formPqpr(8, 0.5, 5));
    for (const Damage& damage : damages) {
        Json json = whole;
        json[Json::json_pointer(damage.pointer)] = Json::parse(damage.value);
        expectError(ErrorKind::input, damage.says, [&] { formFromJson(JsonField(json, "text")); });
    }
}

TEST(FormJson, EveryPrefixOfTheTextIsRefused)
{
    const std::string text = jsonFromForm(formPqpr(8, 0.5, 5)).dump();
    for (size_t size = 0; size < text.size(); ++size)
        expectError(ErrorKind::input, "not JSON", [&] { parseJson(text.substr(0, size), "text"); });
}

TEST(FormJson, DeepNestingAndHugeNumbersAreErrors)
{
    expectError(ErrorKind::input, "not JSON", [] { parseJson(std::string(100000, '['), "text"); });
    const std::string closed = std::string(100000, '[') + std::string(100000, ']');
    expectError(ErrorKind::input, "expected an object", [&] {
        const Json json = parseJson(closed, "text");
        formFromJson(JsonField(json, "text"));
    });
    expectError(ErrorKind::input, "text", [] { parseJson("{\"size\": 1e999}", "text"); });
}

}  // namespace
