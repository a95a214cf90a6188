#include <fbrdf/peers/PublishedFits.h>

#include "support/TemporaryDir.h"

#include <fbrdf/base/Error.h>
#include <gtest/gtest.h>

#include <fstream>

namespace fbrdf {
namespace {

std::string written(const test::TemporaryDir& folder, const std::string& text)
{
    const std::string path = folder.file("table.csv");
    std::ofstream(path) << text;
    return path;
}

TEST(PublishedFits, AreFoundByName)
{
    const test::TemporaryDir folder;
    const auto path = written(folder, "material,kd_r,kd_g,kd_b,B\nbrass,1,2,3,4\ngold,5,6,7,8.5\n");
    const ParameterRow row = publishedRow(path, "gold");
    EXPECT_EQ(row.at("kd_g"), 6.0);
    EXPECT_EQ(row.at("B"), 8.5);
    EXPECT_EQ(specFromRow("m", row, {{"a", "kd"}, {"b", "B"}}), "m:a=5/6/7,b=8.5");
}

TEST(PublishedFits, AreEmptyWhereNothingWasPublished)
{
    const test::TemporaryDir folder;
    EXPECT_TRUE(publishedRow(written(folder, "material,B\nbrass,1\n"), "gold").empty());
    EXPECT_TRUE(publishedRow(folder.file("absent.csv"), "gold").empty());
}

TEST(PublishedFits, NameTheLineThatIsWrong)
{
    const test::TemporaryDir folder;
    const auto messageOf = [&](const std::string& text) -> std::string {
        try {
            publishedRow(written(folder, text), "gold");
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::input);
            return error.what();
        }
        return "nothing thrown";
    };
    EXPECT_NE(messageOf("material,B\nbrass,1\ngold,1,2\n").find("table.csv:3"), std::string::npos);
    EXPECT_NE(messageOf("material,B\ngold,one\n").find("'one'"), std::string::npos);
    EXPECT_THROW(specFromRow("m", {{"B", 1.0}}, {{"a", "kd"}}), Error);
}

}  // namespace
}  // namespace fbrdf
