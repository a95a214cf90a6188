// Osgviewer.h - runs the real osgviewer in an X server of its own (Xvfb), and draws the same scene
// in a viewer of this process without a display, for comparison.
#pragma once
#include "OsgScene.h"

#include "support/TemporaryDir.h"

#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

namespace fbrdf::test {

/// 8 bits a channel, RGB, rows from the top.
struct Screen {
    int width = 0, height = 0;
    std::vector<unsigned char> rgb;

    /// The picture of a screen that Xvfb keeps in a file (X Window Dump, 32 bits a pixel); empty
    /// while the file is not whole.
    static Screen ofDump(const std::string& dump);
    /// A picture from a file; empty, with a failure of the test, where it cannot be read.
    static Screen ofFile(const std::string& file);
    void save(const std::string& pngFile) const;
};

/// Pixels that show neither the root window's black nor the background of osgViewer.
size_t drawnPixels(const Screen& screen);
/// The number of pixels any of whose channels are more than `levels` apart; all, where sizes
/// differ.
size_t pixelsApart(const Screen& a, const Screen& b, int levels = 3);

/// `left` with `right` at its right side; they are of one height.
Screen beside(const Screen& left, const Screen& right);

/// osgviewer, or another program with its keys, with the plugins that OSG_LIBRARY_PATH names and
/// nothing else, from the constructor to the destructor. It runs in a folder of its own.
class Osgviewer {
public:
    struct Options {
        int width = 160, height = 160;  ///< of a screen; the window covers it unless `window`
        int screens = 1;                ///< with two: a window, a context and a view on each
        std::string window;             ///< "x y width height"
        std::string arguments;
        std::string program = "osgviewer";
        std::string libraryPath = FBRDF_OSG_LIBRARY_PATH;
        std::string environment;  ///< of the program: "NAME=value NAME=value"
    };
    /// scene: one file or several.
    Osgviewer(const std::string& scene, const Options& options);
    ~Osgviewer() { close(); }
    Osgviewer(const Osgviewer&) = delete;
    Osgviewer& operator=(const Osgviewer&) = delete;

    /// True where the machine has the programs that this needs.
    static bool installed();

    Screen screen(int number = 0) const;
    /// A file that the program writes to where it runs.
    std::string file(const std::string& name) const { return folder_.file(name); }
    /// The program's output: errors (OSG's WARN) at once, the rest when it has ended.
    std::string output() const;
    /// Runs commands of xdotool ("key f click 1") with the pointer over the window.
    void does(const std::string& commands);
    /// Presses Escape and gives the program 10 s to end by itself. Returns its exit status; -1
    /// where it had to be killed.
    int quit();

private:
    void close();

    TemporaryDir folder_;
    std::FILE* shell_ = nullptr;
};

/// Asks until the condition is true, for 60 s at most.
template <class Condition>
bool eventually(const Condition& condition)
{
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end) return false;
        OpenThreads::Thread::microSleep(50000);
    }
    return true;
}

/// A viewer that is set up as osgviewer sets up its own.
class ViewerTwin {
public:
    ViewerTwin(HeadlessContext::Load load, osg::Node* scene, int width, int height);
    ~ViewerTwin() { viewer_->setSceneData(nullptr); }

    Screen frame();
    /// Chooses the terrain manipulator (key 4) and turns the wheel down twice.
    void zoomOverTerrain();
    osg::Matrixd viewMatrix() const { return viewer_->getCamera()->getViewMatrix(); }

private:
    Offscreen offscreen_;
    osg::ref_ptr<osgViewer::Viewer> viewer_;
    osg::ref_ptr<osgViewer::GraphicsWindowEmbedded> window_;
};

}  // namespace fbrdf::test
