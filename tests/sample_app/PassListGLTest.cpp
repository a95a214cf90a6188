// PassListGLTest.cpp - the passes that the panel of a window lists, with their times.
#include "viewer/PassList.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/headless/Context.h>
#include <gtest/gtest.h>

#include <optional>

namespace fbrdf::viewer {
namespace {

Pass litPass(int first, int count)
{
    Pass pass;
    pass.parts.resize(1);
    pass.lit = true;
    pass.firstLight = first;
    pass.lightCount = count;
    return pass;
}

TEST(PassNames, SayWhatAPassAdds)
{
    Pass pass = litPass(4, 1);
    gl::PassEvent event{"gold", 1, 3, &pass, 2};
    EXPECT_EQ(passName(event), "2/3 light 5");
    pass = litPass(0, 8);
    EXPECT_EQ(passName(event), "2/3 lights 1-8");
    pass.lobes.count = 2;
    EXPECT_EQ(passName(event), "2/3 lights 1-8, environment");
    pass.lobes.environment = false;
    pass.lobes.areaCount = 3;
    EXPECT_EQ(passName(event), "2/3 lights 1-8, shapes");
    pass = Pass();
    EXPECT_EQ(passName(event), "2/3 no light");
    pass.parts.resize(1);
    EXPECT_EQ(passName(event), "2/3 factors of the view");
}

class ListedPasses : public testing::Test {
protected:
    void SetUp() override
    {
        try {
            context_.emplace(HeadlessOptions{});
        } catch (const Error& error) {
            GTEST_SKIP() << error.what();
        }
        list_.emplace(context_->loader());
    }
    void draw(int passes, const char* material = "gold")
    {
        const gl::PassWatch watch = list_->watch();
        list_->begin();
        const Pass pass = litPass(0, 1);
        for (int i = 0; i < passes; ++i) {
            const gl::PassEvent event{material, i, passes, &pass, 2};
            watch.begins(event);
            watch.ends(event);
        }
    }

    std::optional<HeadlessContext> context_;
    std::optional<PassList> list_;
};

TEST_F(ListedPasses, AreThoseOfTheLastDraw)
{
    draw(3);
    ASSERT_EQ(list_->rows().size(), 3u);
    EXPECT_EQ(list_->rows()[2].name, "3/3 light 1");
    EXPECT_EQ(list_->rows()[2].lookups, 2);
    EXPECT_EQ(list_->left(), 0);
    draw(1);
    EXPECT_EQ(list_->rows().size(), 1u);
    draw(5000);
    EXPECT_EQ(list_->rows().size(), PassList::kMostRows);
    EXPECT_EQ(list_->left(), 5000 - static_cast<int>(PassList::kMostRows));
}

TEST_F(ListedPasses, HaveTimesOfADrawBeforeOfTheSamePasses)
{
    const GladGLContext gl = loadGlFunctions(context_->loader());
    GLint bits = 0;
    gl.GetQueryiv(GL_TIME_ELAPSED, GL_QUERY_COUNTER_BITS, &bits);
    if (bits == 0) GTEST_SKIP() << "no timer queries";
    draw(2);
    EXPECT_FALSE(list_->rows()[0].milliseconds) << "it has not ended";
    gl.Finish();
    draw(2);
    for (const PassRow& row : list_->rows()) {
        ASSERT_TRUE(row.milliseconds) << row.name;
        EXPECT_GE(*row.milliseconds, 0.0);
    }
    gl.Finish();
    draw(2, "another");
    EXPECT_FALSE(list_->rows()[0].milliseconds) << "that was the time of another pass";
    EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

}  // namespace
}  // namespace fbrdf::viewer
