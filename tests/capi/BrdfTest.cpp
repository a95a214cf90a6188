// BRDFs of the C ABI, descriptors of other versions, texts; no GL.
#include "plain.h"

#include <fbrdf/fbrdf.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace fbrdf::test {
namespace {

struct Log {
    std::string text;
    fbrdf_log log{[](void* user, fbrdf_severity, fbrdf_result, const char* line) {
                      static_cast<Log*>(user)->text = line;
                  },
                  this};
};

/// A pqp of 3 x 3 texels with room to be made wrong.
struct Given {
    std::vector<float> texels = std::vector<float>(27, -1.0f);
    std::array<const float*, 2> tables{texels.data(), texels.data()};
    fbrdf_brdf_desc desc = abi::describe<fbrdf_brdf_desc>();
    Given()
    {
        desc.size[0] = 3;
        desc.table_count = 2;
        desc.tables = tables.data();
    }
    fbrdf_result create(Log& log, abi::Brdf& brdf) const
    {
        return brdf.create(fbrdf_brdf_create, &desc, &log.log);
    }
};

TEST(CApiBrdf, EvaluatesWhatItWasGiven)
{
    Log log;
    abi::Brdf brdf;
    ASSERT_EQ(Given().create(log, brdf), FBRDF_OK) << log.text;
    const float up[3] = {0.0f, 0.0f, 1.0f}, below[3] = {0.0f, 0.6f, -0.8f};
    float rgb[3] = {};
    ASSERT_EQ(fbrdf_brdf_evaluate(brdf.get(), up, up, rgb), FBRDF_OK);
    for (const float channel : rgb) EXPECT_NEAR(channel, 0.125f, 1e-6f);  // p q p, each 1/2
    ASSERT_EQ(fbrdf_brdf_evaluate(brdf.get(), up, below, rgb), FBRDF_OK);
    for (const float channel : rgb) EXPECT_EQ(channel, 0.0f);
    EXPECT_EQ(fbrdf_brdf_evaluate(nullptr, up, up, rgb), FBRDF_ERROR_ARGUMENT);
    EXPECT_EQ(fbrdf_brdf_evaluate(brdf.get(), up, nullptr, rgb), FBRDF_ERROR_ARGUMENT);
}

TEST(CApiBrdf, RefusesWhatIsWrong)
{
    Log log;
    abi::Brdf brdf;
    const auto expectRefused = [&](const Given& given, fbrdf_result expected, const char* words) {
        EXPECT_EQ(given.create(log, brdf), expected) << words;
        EXPECT_FALSE(brdf);
        EXPECT_NE(log.text.find(words), std::string::npos) << log.text;
    };
    Given given;
    given.desc.form = 17;
    expectRefused(given, FBRDF_ERROR_ARGUMENT, "form: found 17");
    for (const int size : {-1, 0, 1, 1 << 30}) {
        given = Given();
        given.desc.tables = given.tables.data();
        given.desc.size[0] = size;
        expectRefused(given, FBRDF_ERROR_ARGUMENT, "size[0]");
    }
    Given few;
    few.desc.table_count = 1;
    expectRefused(few, FBRDF_ERROR_ARGUMENT, "1 tables, expected 2");
    Given none;
    none.tables[1] = nullptr;
    expectRefused(none, FBRDF_ERROR_ARGUMENT, "table 'q'");
    Given nan;
    nan.texels[5] = std::numeric_limits<float>::quiet_NaN();
    expectRefused(nan, FBRDF_ERROR_INPUT, "brdf");
    EXPECT_EQ(fbrdf_brdf_create(nullptr, &log.log, nullptr), FBRDF_ERROR_ARGUMENT);
    EXPECT_EQ(brdf.create(fbrdf_brdf_load, "no such file", &log.log), FBRDF_ERROR_INPUT);
    EXPECT_NE(log.text.find("no such file"), std::string::npos) << log.text;
}

// A program compiled against a later header: what it adds may be there, unless it means something.
TEST(CApiBrdf, NewerDescriptorsAreReadAsFarAsTheyAreZero)
{
    struct Newer {
        fbrdf_brdf_desc known;
        uint32_t added[4];
    };
    const Given given;
    Newer newer{given.desc, {}};
    newer.known.struct_size = sizeof newer;
    Log log;
    abi::Brdf brdf;
    EXPECT_EQ(brdf.create(fbrdf_brdf_create, &newer.known, &log.log), FBRDF_OK) << log.text;
    newer.added[2] = 1;
    EXPECT_EQ(brdf.create(fbrdf_brdf_create, &newer.known, &log.log), FBRDF_ERROR_VERSION);
    EXPECT_TRUE(brdf);  // keeps what it held
    newer.known.struct_size = 8;
    EXPECT_EQ(brdf.create(fbrdf_brdf_create, &newer.known, &log.log), FBRDF_ERROR_VERSION);
}

TEST(CApiBrdf, TextsAreThere)
{
    EXPECT_EQ(fbrdf_api_version(), FBRDF_API_VERSION);
    for (int result = FBRDF_OK; result <= FBRDF_ERROR_INTERNAL; ++result)
        EXPECT_GT(std::string(fbrdf_result_text(static_cast<fbrdf_result>(result))).size(), 3u);
    const char* const names[] = {"fbrdfZenith", "fbrdfDisc", "fbrdfFrame", "fbrdfIrradiance",
                                 "fbrdfSrgbFromLinear"};
    for (uint32_t i = 0; i < 5; ++i)
        EXPECT_NE(std::string(fbrdf_glsl_snippet(i)).find(names[i]), std::string::npos) << i;
    EXPECT_EQ(fbrdf_glsl_snippet(5), nullptr);
}

}  // namespace
}  // namespace fbrdf::test
