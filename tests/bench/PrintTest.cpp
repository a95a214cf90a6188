#include "bench/Print.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace fbrdf::bench {
namespace {

Measurement twoTables()
{
    Measurement m;
    m.glRenderer = "software";
    m.glVersion = "4.5";
    m.width = 64;
    m.height = 32;
    m.tables = {{"triangle", 1, {{"ggx", 2.0, 1.0, 9}, {"merl", 5.0, 2.5, 9}}, {}},
                {"triangle", 4, {{"ggx", 8.0, 1.0, 9}}, {{"merl", "about 9000 ms a frame"}}},
                {"sphere", 1, {{"merl", 4.0, 0.0, 3}}, {}}};
    return m;
}

TEST(BenchText, HasARowAVariantAndNamesWhatIsLeftOut)
{
    const std::string text = asText(twoTables());
    EXPECT_NE(text.find("software, OpenGL 4.5, 64x32 pixels, wall time"), std::string::npos);
    EXPECT_NE(text.find("triangle: ms a frame"), std::string::npos);
    EXPECT_NE(text.find("sphere: ms a frame"), std::string::npos);
    EXPECT_NE(text.find("5.00   2.50        -"), std::string::npos) << text;
    EXPECT_NE(text.find("left out: merl with 4 lights (about 9000 ms a frame)"), std::string::npos);
}

TEST(BenchJson, HoldsEveryTiming)
{
    const auto json = nlohmann::json::parse(asJson(twoTables()));
    ASSERT_EQ(json["results"].size(), 4u);
    EXPECT_EQ(json["renderer"], "software");
    EXPECT_EQ(json["size"][1], 32);
    EXPECT_EQ(json["results"][1]["variant"], "merl");
    EXPECT_EQ(json["results"][1]["ratio"], 2.5);
    EXPECT_EQ(json["results"][2]["lights"], 4);
    EXPECT_TRUE(json["results"][3]["ratio"].is_null());  // ggx was not timed there
    EXPECT_EQ(json["left_out"][0]["variant"], "merl");
}

}  // namespace
}  // namespace fbrdf::bench
