// OptionsTest.cpp - the command line of fbrdf-viewer.
#include "support/CommaLocale.h"
#include "viewer/Options.h"

#include <gtest/gtest.h>

#include <array>

namespace fbrdf::viewer {
namespace {

// Toolkits set the locale of their user's language at their start.
TEST(ViewerOptions, NumbersHaveAPointWhereTheDecimalSignIsAComma)
{
    const test::CommaLocale comma;
    const std::array arguments{"fbrdf-viewer", "--exposure",
                               "0.25",         "--environment-rotation",
                               "12.5",         "--environment-intensity",
                               "1.5"};
    const Options options =
        optionsFromArguments(static_cast<int>(arguments.size()), arguments.data());
    EXPECT_EQ(options.document.exposure, 0.25f);
    EXPECT_EQ(options.document.environment.degrees, 12.5f);
    EXPECT_EQ(options.document.environment.intensity, 1.5f);
}

}  // namespace
}  // namespace fbrdf::viewer
