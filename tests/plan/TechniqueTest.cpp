#include <fbrdf/base/Error.h>
#include <fbrdf/plan/Technique.h>

#include <gtest/gtest.h>

#include <set>

namespace fbrdf {
namespace {

TEST(Techniques, AreListedOnceEach)
{
    std::set<Technique> listed;
    std::set<std::string> names, titles;
    for (const Technique t : allTechniques()) {
        const TechniqueInfo& info = techniqueInfo(t);
        EXPECT_EQ(info.technique, t);
        listed.insert(t);
        names.insert(info.name);
        titles.insert(info.title);
    }
    const std::set<Technique> expected{Technique::single, Technique::batched, Technique::twoLookup};
    EXPECT_EQ(listed, expected);
    EXPECT_EQ(names, (std::set<std::string>{"single", "batched", "two-lookup"}));
    EXPECT_EQ(titles.size(), names.size());
}

TEST(Techniques, AreFoundByName)
{
    for (const Technique t : allTechniques()) EXPECT_EQ(techniqueFromName(techniqueName(t)), t);
    for (const char* unknown : {"", "deferred", "Single", "two look-ups per pass"})
        EXPECT_THROW(techniqueFromName(unknown), Error) << unknown;
}

TEST(Techniques, AreNamedInTheErrorAboutAnUnknownOne)
{
    try {
        techniqueFromName("deferred");
        FAIL() << "expected an error";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        EXPECT_NE(std::string(error.what()).find("'deferred', expected one of " + techniqueNames()),
                  std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace fbrdf
