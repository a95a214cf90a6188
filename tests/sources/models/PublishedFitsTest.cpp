// PublishedFitsTest.cpp - SGD and ABC with the parameters that their papers give for MERL materials
// (collected by Peers; Bagher et al. 2012, Low et al. 2012), against the same formulas in numpy,
// and Ward's table.
#include "ExpectedValues.h"
#include "Pairs.h"

#include <fbrdf/base/Number.h>
#include <fbrdf/base/Text.h>
#include <fbrdf/sources/Model.h>
#include <gtest/gtest.h>

#include <support/DataDir.h>
#include <fstream>
#include <sstream>

namespace fbrdf::test {
namespace {

TEST(Sgd, GreenMetallicPaintOfBagher2012)
{
    expectValues(
        "sgd:kd=0.00368935/0.0155555/0.022272,ks=0.185621/0.436002/0.322925,"
        "alpha=0.131402/0.146271/0.154061,p=1.28366/0.865104/0.944013,"
        "f0=0.12483/0.0443223/0.0955612,f1=0.028874/-0.118581/-0.139373,"
        "K=3.62502/5.13725/4.71161,Lambda=1.97389/2.72437/2.63239,"
        "c=5.5607e-08/1.1239e-07/9.76666e-08,k=27.5467/23.1688/23.2911,"
        "theta0=-0.204638/-0.326555/-0.334024",
        {{0.0618601705388, 0.149880468787, 0.167977026907},
         {0.0489909135701, 0.162221521731, 0.160551349228},
         {0.0011793416627, 0.00507227827584, 0.00724263594178}});
}

TEST(Sgd, BrassOfBagher2012)
{
    expectValues(
        "sgd:kd=0.0301974/0.0223812/0.0139381,ks=0.0557826/0.0376687/0.0775998,"
        "alpha=0.0002028/0.000258468/0.00096108,p=0.362322/0.401593/0.776606,"
        "f0=0.639886/0.12354/0.0197853,f1=-0.360114/-0.87646/-0.0919344,"
        "K=3517.61/2612.49/331.815,Lambda=3.64061/2.87206/0.529487,"
        "c=1.01146e-07/9.83073e-08/5.48819e-08,k=312.802/283.431/183.091,"
        "theta0=0.522711/0.516719/0.474834",
        {{0.00961213095705, 0.00712415722466, 0.00443706782561},
         {0.00961213095705, 0.00712415722466, 0.00443663502462},
         {0.00961213095705, 0.00712415722466, 0.00443663502462}});
}

TEST(Abc, BrassAndBlueRubberOfLow2012)
{
    expectValues(
        "abc:kd=0.0077/0.0125/0.0109,A=2975.157/1931.13717/987.87736,B=244596.536112,C=1.136163,"
        "eta=2.69869",
        {{0.085255111707, 0.0577259950716, 0.0309640330028},
         {0.0449642371493, 0.0315736926988, 0.017585766649},
         {0.00353418091388, 0.0046819617578, 0.00382924402568}});
    expectValues(
        "abc:kd=0.0354/0.0741/0.1546,A=1.29571/1.27954/1.24892,B=37.265716,C=1.565906,eta=1.44861",
        {{0.0280484767052, 0.0401576570402, 0.0653850535018},
         {0.0826636752109, 0.0940912772916, 0.118028016601},
         {0.0118149442602, 0.0241267133068, 0.0497377378669}});
}

TEST(Abc, FresnelHasItsLimits)
{
    // At normal incidence f = A ((eta - 1) / (eta + 1))^2 / pi; index 1 reflects nothing.
    const Vec3d normal(0.0, 0.0, 1.0);
    EXPECT_NEAR(makeModelSource("abc:kd=0,A=2,eta=1.5").evaluate(normal, normal).x,
                2.0 * 0.04 / kPi, 1e-15);
    EXPECT_EQ(makeModelSource("abc:kd=0,A=2,eta=1").evaluate(normal, normal).x, 0.0);
}

struct Row {
    std::string name;
    std::vector<double> values;
};

/// The rows of a CSV file with a header line and a name in the first column.
std::vector<Row> readTable(const std::string& path)
{
    std::ifstream file(path);
    std::string line, field;
    std::getline(file, line);
    std::vector<Row> rows;
    while (std::getline(file, line)) {
        std::istringstream fields(line);
        Row row;
        std::getline(fields, row.name, ',');
        while (std::getline(fields, field, ','))
            EXPECT_TRUE(parseNumber(trimmed(field), row.values.emplace_back())) << line;
        rows.push_back(row);
    }
    return rows;
}

/// "name=v/v/v" for each colour of a row, from column `first` on, joined by commas.
std::string colours(const Row& row, const std::vector<std::string>& names)
{
    std::string text;
    for (size_t k = 0; k < names.size(); ++k) {
        text += (k ? "," : "") + names[k] + "=";
        for (size_t c = 0; c < 3; ++c)
            text += (c ? "/" : "") + numberText(row.values[3 * k + c], 17);
    }
    return text;
}

void expectSound(const std::string& name, const std::string& spec)
{
    SCOPED_TRACE(name);
    const Source source = makeModelSource(spec);
    for (const auto& pair : spreadPairs(200)) {
        const Vec3d f = source.evaluate(pair.wo, pair.wi), g = source.evaluate(pair.wi, pair.wo);
        for (int c = 0; c < 3; ++c) {
            ASSERT_TRUE(std::isfinite(f[c]) && f[c] >= 0.0);
            ASSERT_NEAR(f[c], g[c], 1e-6 * f[c]);
        }
    }
}

TEST(PublishedFits, EverySgdMaterialIsInRangeAndSound)
{
    FBRDF_NEEDS_DATA("merl_fits/csv/bagher_sgd.csv");
    const std::vector<Row> rows = readTable(dataPath("merl_fits/csv/bagher_sgd.csv"));
    EXPECT_GE(rows.size(), 50u);
    for (const Row& row : rows)
        expectSound(row.name, "sgd:" + colours(row, {"kd", "ks", "alpha", "p", "f0", "f1", "K",
                                                     "Lambda", "c", "k", "theta0"}));
}

TEST(PublishedFits, EveryAbcMaterialIsInRangeAndSound)
{
    FBRDF_NEEDS_DATA("merl_fits/csv/low_lowmicrofacet_E2.csv");
    const std::vector<Row> rows = readTable(dataPath("merl_fits/csv/low_lowmicrofacet_E2.csv"));
    EXPECT_GE(rows.size(), 50u);
    for (const Row& row : rows) {
        const auto value = [&](size_t k) { return numberText(row.values[k], 17); };
        const std::string rest = ",B=" + value(6) + ",C=" + value(7) + ",eta=" + value(8);
        expectSound(row.name, "abc:" + colours(row, {"kd", "A"}) + rest);
    }
}

TEST(PublishedFits, WardPresetsAreTheTable)
{
    FBRDF_NEEDS_DATA("ward1992/ward1992.csv");
    const std::vector<Row> rows = readTable(dataPath("ward1992/ward1992.csv"));
    EXPECT_EQ(rows.size(), 6u);
    for (Row row : rows) {
        for (char& c : row.name)
            if (c == '_') c = '-';
        const ModelValues values = parseModelSpec("ward-" + row.name).values;
        const char* names[] = {"rho_d", "rho_s", "alpha_x", "alpha_y"};
        for (size_t k = 0; k < 4; ++k) EXPECT_EQ(values.at(names[k]).x, row.values[k]) << row.name;
    }
}

}  // namespace
}  // namespace fbrdf::test
