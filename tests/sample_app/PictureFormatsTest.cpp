// PictureFormatsTest.cpp - pictures of fbrdf-viewer beside OpenEXR and PNG: OpenImageIO is loaded
// for them alone, and its absence is reported before anything is drawn.
#include "Program.h"

#include <gtest/gtest.h>
#include <support/TemporaryDir.h>

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <filesystem>

namespace fbrdf::scene {
namespace {

class PictureFormats : public testing::Test {
protected:
    ProgramResult draw(const std::string& picture, const std::string& prefix = "")
    {
        return runProgram(program_,
                          "--headless --size 24x16 --material lambert:albedo=0.5 --technique "
                          "reference --out '" +
                              dir_.file(picture) + "'",
                          prefix);
    }

    test::TemporaryDir dir_;
    std::string program_ = viewerPath();
};

// The loader of glibc lists every file that it loads.
TEST_F(PictureFormats, OpenImageIOIsLoadedForThemAlone)
{
    for (const char* name : {"a.png", "a.exr"}) {
        const ProgramResult result = draw(name, "LD_DEBUG=files");
        EXPECT_EQ(result.exitCode, 0);
        EXPECT_NE(result.err.find("libpng"), std::string::npos);
        EXPECT_EQ(result.err.find("libOpenImageIO"), std::string::npos) << name;
    }
    const ProgramResult result = draw("a.jpg", "LD_DEBUG=files");
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_NE(result.err.find("libOpenImageIO"), std::string::npos);
}

TEST_F(PictureFormats, AreWrittenAsTheirExtensionAsks)
{
    const std::pair<const char*, const char*> cases[] = {
        {"a.bmp", "bmp"}, {"a.gif", "gif"},   {"a.hdr", "hdr"},   {"a.jpeg", "jpeg"},
        {"a.ppm", "pnm"}, {"a.tga", "targa"}, {"a.tiff", "tiff"}, {"a.webp", "webp"}};
    for (const auto& [name, format] : cases) {
        const ProgramResult result = draw(name);
        ASSERT_EQ(result.exitCode, 0) << result.err;
        EXPECT_EQ(result.err, "");
        const auto file = OIIO::ImageInput::open(dir_.file(name));
        ASSERT_TRUE(file) << name << OIIO::geterror();
        EXPECT_STREQ(file->format_name(), format);
        EXPECT_EQ(file->spec().width, 24);
        EXPECT_EQ(file->spec().height, 16);
    }
    EXPECT_EQ(dir_.names().size(), std::size(cases));  // no temporary file is left
}

void expectNoModule(const ProgramResult& result, const std::string& path)
{
    EXPECT_EQ(result.exitCode, 5);
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    for (const std::string& word :
         {path, std::string("a.jpg: found no module"), std::string("libopenimageio-dev")})
        EXPECT_NE(result.err.find(word), std::string::npos) << result.err;
}

TEST_F(PictureFormats, WithoutTheModuleAreRefusedAndTheOthersAreNot)
{
    const std::string missing = "FBRDF_PICTURES_MODULE=" + dir_.file("none.so");
    expectNoModule(draw("a.jpg", missing), dir_.file("none.so"));
    EXPECT_EQ(dir_.names().size(), 0u);
    EXPECT_EQ(draw("a.png", missing).exitCode, 0);
}

// The layout of an install tree: the module is found from the folder of the program.
TEST_F(PictureFormats, FollowAProgramThatIsMovedWithItsModule)
{
    namespace fs = std::filesystem;
    const fs::path toModule = fs::relative(FBRDF_PICTURE_MODULE_PATH,
                                           fs::path(viewerPath()).parent_path()),
                   program = dir_.file("there/bin/fbrdf-viewer"),
                   module = (program.parent_path() / toModule).lexically_normal();
    fs::create_directories(program.parent_path());
    fs::copy(viewerPath(), program);
    program_ = program.string();
    expectNoModule(draw("a.jpg"), module.string());
    fs::create_directories(module.parent_path());
    fs::copy(FBRDF_PICTURE_MODULE_PATH, module);
    EXPECT_EQ(draw("a.jpg").exitCode, 0);
}

}  // namespace
}  // namespace fbrdf::scene
