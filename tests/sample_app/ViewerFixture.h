// ViewerFixture.h - what tests of fbrdf-viewer share: a material made from formulas, and pictures
// of the program read back.
#pragma once
#include "GlPictures.h"
#include "PictureDifference.h"
#include "Program.h"

#include <fbrdf/base/OutputFile.h>
#include <fbrdf/io/MaterialFile.h>
#include <gtest/gtest.h>
#include <support/TemporaryDir.h>

#include <algorithm>

namespace fbrdf::scene {

constexpr double kAgainstReference = 2e-3;  // as TechniquesGLTest.cpp
constexpr double kBetweenTechniques = 1e-4;

class Viewer : public testing::Test {
protected:
    Viewer() { writeMaterial(madeMaterial(formPqp(16, 0.5)), file("made.fbrdf")); }

    std::string file(const std::string& name) const { return dir_.file(name); }
    /// Arguments that draw the made material without a display, small.
    std::string drawMade() const
    {
        return "--headless --size 48x48 --material '" + file("made.fbrdf") + "' ";
    }
    Image draw(const std::string& arguments)
    {
        const ProgramResult result = runViewer(arguments + " --out '" + file("p.exr") +
                                               "' --stats '" + file("s.json") + "'");
        EXPECT_EQ(result.exitCode, 0) << result.err;
        EXPECT_EQ(result.err, "");
        EXPECT_EQ(result.out, "");
        stats_ = readJson(file("s.json"));
        return readExr(file("p.exr"));
    }

    test::TemporaryDir dir_;
    nlohmann::json stats_;
};

#define NEEDS(backend) \
    if (!hasBackend(backend)) GTEST_SKIP() << "no context on " << backendName(backend)

/// The exit code, one line on stderr that begins like the tool and names `where`, and no picture.
inline void expectError(const ProgramResult& result, int exitCode, const std::string& where)
{
    EXPECT_EQ(result.exitCode, exitCode) << result.err;
    EXPECT_EQ(result.err.substr(0, 14), "fbrdf-viewer: ");
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_NE(result.err.find(where), std::string::npos) << result.err;
    EXPECT_EQ(result.out, "");
}

/// Tests of windows need Xvfb.
class ViewerWindow : public Viewer {
protected:
    void SetUp() override
    {
        if (!hasCommand("Xvfb")) GTEST_SKIP() << "needs Xvfb (Debian: xvfb)";
    }
    const std::string xvfb_ = "tests/support/with_x.sh env -u WAYLAND_DISPLAY";
};

/// Tests that press keys in a window need xdotool.
class ViewerActions : public ViewerWindow {
protected:
    void SetUp() override
    {
        ViewerWindow::SetUp();
        if (!hasCommand("xdotool")) GTEST_SKIP() << "needs xdotool";
        if (!hasBackend(Backend::egl)) GTEST_SKIP() << "no context on egl";
    }
    /// A window, the keys that are pressed in it one after the other, and Q. It runs in the folder
    /// of the test's files.
    ProgramResult press(const std::string& arguments, const std::string& keys)
    {
        return act(arguments, "for key in " + keys + "; do xdotool key $key; sleep 0.7; done\n");
    }
    /// The same with commands of a shell.
    ProgramResult act(const std::string& arguments, const std::string& commands)
    {
        const std::string program = file("keys.sh");
        writeFile(program,
                  "cd '" + file("") +
                      "'\nexport XDG_CACHE_HOME=$PWD/caches\n\"$@\" & viewer=$!\n"
                      "until xdotool search --onlyvisible --name fbrdf >/dev/null 2>&1; do\n"
                      "  kill -0 $viewer || exit 1; sleep 0.1\n"
                      "done\n"
                      "xdotool mousemove 60 40\nsleep 1\n" +
                      commands + "xdotool key q\nwait $viewer\n");
        return runViewer("--size " + size_ + " " + arguments, xvfb_ + " bash '" + program + "'");
    }
    std::string size_ = "96x64";
};

}  // namespace fbrdf::scene
