// ModuleTest.cpp - when the module is opened, and how its absence is reported. Each test starts
// as a process of its own, because a module stays open.
#include <fbrdf/codecs/PictureFile.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>

namespace fbrdf {
namespace {

bool isLoaded(const std::string& library)
{
    std::ifstream maps("/proc/self/maps");
    const std::string text(std::istreambuf_iterator<char>(maps), {});
    return text.find(library) != std::string::npos;
}

/// Writes the error that opening the module throws, and ends the process with its kind.
[[noreturn]] void openAndExit()
{
    try {
        requirePictureModule(ErrorKind::output, "a.jpg");
        std::exit(0);
    } catch (const Error& error) {
        std::cerr << error.what() << std::flush;
        std::exit(static_cast<int>(error.kind()));
    }
}

[[noreturn]] void openAt(const char* path)
{
    setenv("FBRDF_PICTURES_MODULE", path, 1);
    openAndExit();
}

class Module : public testing::Test {
protected:
    Module() { testing::GTEST_FLAG(death_test_style) = "threadsafe"; }
};

TEST_F(Module, IsOpenedByTheFirstPictureAndNotBefore)
{
    EXPECT_EXIT(
        {
            const bool before = isLoaded("OpenImageIO") || pictureFormatOf("a.jpg") == nullptr;
            requirePictureModule(ErrorKind::output, "a.jpg");
            std::exit(!before && isLoaded("fbrdf_pictures_oiio.so") && isLoaded("libOpenImageIO")
                          ? 0
                          : 1);
        },
        testing::ExitedWithCode(0), "");
}

TEST_F(Module, ThatIsMissingIsNamedWithItsPathAndPackage)
{
    const auto output = testing::ExitedWithCode(static_cast<int>(ErrorKind::output));
    EXPECT_EXIT(openAt("/nonexistent/module.so"), output,
                "^a.jpg: found no module for pictures of this format .*/nonexistent/module.so.*, "
                "expected fbrdf_pictures_oiio.so .*libopenimageio-dev.*FBRDF_PICTURES_MODULE$");
}

TEST_F(Module, ThatIsAnotherLibraryIsRefused)
{
    const auto output = testing::ExitedWithCode(static_cast<int>(ErrorKind::output));
    EXPECT_EXIT(openAt("libm.so.6"), output, "libm.so.6 is no module of fbrdf");
    EXPECT_EXIT(openAt(FBRDF_NEWER_MODULE), output, "has version 1000, not 3\\)");
}

}  // namespace
}  // namespace fbrdf
