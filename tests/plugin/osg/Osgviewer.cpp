#include "Osgviewer.h"

#include <OpenImageIO/imageio.h>
#include <osgGA/KeySwitchMatrixManipulator>
#include <osgGA/TerrainManipulator>
#include <osgGA/TrackballManipulator>
#include <osgUtil/Optimizer>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <locale>
#include <sstream>

namespace fbrdf::test {
namespace {

std::string contents(const std::string& file)
{
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// A number of the dump's header: 32 bits, big-endian.
size_t headerOf(const std::string& dump, size_t index)
{
    size_t value = 0;
    for (size_t i = 0; i < 4; ++i)
        value = value << 8 | static_cast<unsigned char>(dump.at(4 * index + i));
    return value;
}

/// A display number at which no other test looks first: xvfb-run lets two servers that begin at
/// once take the same. OSG writes a number of four digits as its host's locale groups them.
int displayNumber()
{
    return 200 + getpid() % 800;
}

}  // namespace

Screen Screen::ofDump(const std::string& dump)
{
    Screen screen;
    if (dump.size() < 100) return screen;
    const size_t width = headerOf(dump, 4), height = headerOf(dump, 5), pitch = headerOf(dump, 12),
                 start = headerOf(dump, 0) + 12 * headerOf(dump, 19);
    if (dump.size() < start + pitch * height) return screen;
    screen.width = static_cast<int>(width);
    screen.height = static_cast<int>(height);
    for (size_t y = 0; y < height; ++y)
        for (size_t x = 0; x < width; ++x)
            for (const size_t channel : {size_t(2), size_t(1), size_t(0)})
                screen.rgb.push_back(
                    static_cast<unsigned char>(dump[start + y * pitch + 4 * x + channel]));
    return screen;
}

Screen Screen::ofFile(const std::string& file)
{
    Screen screen;
    const auto picture = OIIO::ImageInput::open(file);
    if (picture && picture->spec().nchannels == 3) {
        screen.width = picture->spec().width;
        screen.height = picture->spec().height;
        screen.rgb.resize(static_cast<size_t>(screen.width * screen.height) * 3);
    }
    if (screen.rgb.empty() ||
        !picture->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, screen.rgb.data()))
        ADD_FAILURE() << "could not read " << file;
    return screen;
}

void Screen::save(const std::string& pngFile) const
{
    const auto file = OIIO::ImageOutput::create(pngFile);
    if (!file || !file->open(pngFile, OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::UINT8)) ||
        !file->write_image(OIIO::TypeDesc::UINT8, rgb.data()))
        ADD_FAILURE() << "could not write " << pngFile;
}

size_t drawnPixels(const Screen& screen)
{
    size_t count = 0;
    for (size_t i = 0; i < screen.rgb.size(); i += 3) {
        const unsigned char* c = &screen.rgb[i];
        const bool background = c[0] == 51 && c[1] == 51 && c[2] == 102;
        count += background || (c[0] == 0 && c[1] == 0 && c[2] == 0) ? 0 : 1;
    }
    return count;
}

size_t pixelsApart(const Screen& a, const Screen& b, int levels)
{
    if (a.width != b.width || a.height != b.height) return std::max(a.rgb.size(), b.rgb.size()) / 3;
    size_t count = 0;
    for (size_t i = 0; i < a.rgb.size(); i += 3) {
        bool apart = false;
        for (size_t c = i; c < i + 3; ++c) apart |= std::abs(a.rgb[c] - b.rgb[c]) > levels;
        count += apart ? 1 : 0;
    }
    return count;
}

Screen beside(const Screen& left, const Screen& right)
{
    Screen both;
    both.width = left.width + right.width;
    both.height = std::min(left.height, right.height);
    for (int y = 0; y < both.height; ++y)
        for (const Screen* half : {&left, &right}) {
            const auto row = half->rgb.begin() + y * half->width * 3;
            both.rgb.insert(both.rgb.end(), row, row + half->width * 3);
        }
    return both;
}

bool Osgviewer::installed()
{
    return std::system(
               "{ command -v xvfb-run && command -v osgviewer && command -v osgfxbrowser && "
               "command -v xdotool; } >/dev/null") == 0;
}

// A shell beside osgviewer in the X server runs the commands of does() and quit(). A server starts
// anew when its last client leaves, and osgviewer asks for the screens as a client that leaves at
// once: the windows that it opens then would be lost with the old server.
Osgviewer::Osgviewer(const std::string& scene, const Options& options)
{
    std::ostringstream server, viewer;
    for (std::ostringstream* commands : {&server, &viewer})
        commands->imbue(std::locale::classic());  // display 12345 is not 12.345
    server << "cd " << folder_.file("") << " && env -u LD_LIBRARY_PATH -u WAYLAND_DISPLAY "
           << "OSG_GL_ERROR_CHECKING=ONCE_PER_ATTRIBUTE OSG_LIBRARY_PATH=" << options.libraryPath
           << " xvfb-run -a -n " << displayNumber() << " -s '-noreset -fbdir " << folder_.file("");
    for (int i = 0; i < options.screens; ++i)
        server << " -screen " << i << ' ' << options.width << 'x' << options.height << "x24";
    server << "' sh >shell 2>&1";
    viewer << "env " FBRDF_OSG_ENVIRONMENT << options.environment << ' ';
    if (!options.window.empty())
        viewer << "OSG_WINDOW='" << options.window << "' ";
    else if (options.screens == 1)
        viewer << "OSG_WINDOW='0 0 " << options.width << ' ' << options.height << "' ";
    viewer << options.program << ' ' << options.arguments << ' ' << scene
           << " >log 2>&1 </dev/null & viewer=$!\n";
    shell_ = popen(server.str().c_str(), "w");
    if (!shell_) throw std::runtime_error("no shell for xvfb-run");
    std::fputs(viewer.str().c_str(), shell_);
    std::fflush(shell_);
}

void Osgviewer::close()
{
    if (!shell_) return;
    std::fputs("kill $viewer; wait $viewer\n", shell_);
    pclose(shell_);
    shell_ = nullptr;
}

Screen Osgviewer::screen(int number) const
{
    return Screen::ofDump(contents(folder_.file("Xvfb_screen" + std::to_string(number))));
}

std::string Osgviewer::output() const
{
    return contents(folder_.file("log"));
}

void Osgviewer::does(const std::string& commands)
{
    std::fprintf(shell_, "xdotool mousemove 80 80 %s\n", commands.c_str());
    std::fflush(shell_);
}

int Osgviewer::quit()
{
    does("key Escape");
    // Only a viewer that hangs is ended: on a busy machine one takes many seconds to quit.
    std::fputs(
        "{ sleep 120; kill $viewer && echo killed >killed; } & limit=$!\n"
        "wait $viewer\necho $? >status\nkill $limit\n",
        shell_);
    pclose(shell_);
    shell_ = nullptr;
    if (!contents(folder_.file("killed")).empty()) return -1;
    return std::atoi(contents(folder_.file("status")).c_str());
}

ViewerTwin::ViewerTwin(HeadlessContext::Load load, osg::Node* scene, int width, int height)
    : offscreen_(load, {width, height, OffscreenFormat::rgba8, true}),
      viewer_(new osgViewer::Viewer),
      window_(viewer_->setUpViewerAsEmbeddedInWindow(0, 0, width, height))
{
    window_->setDefaultFboId(offscreen_.framebuffer());
    viewer_->setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
    osg::ref_ptr<osgGA::KeySwitchMatrixManipulator> keys = new osgGA::KeySwitchMatrixManipulator;
    keys->addMatrixManipulator('1', "Trackball", new osgGA::TrackballManipulator);
    keys->addMatrixManipulator('4', "Terrain", new osgGA::TerrainManipulator);
    viewer_->setCameraManipulator(keys);
    osg::Camera* camera = viewer_->getCamera();
    camera->setDrawBuffer(GL_COLOR_ATTACHMENT0);
    camera->setReadBuffer(GL_COLOR_ATTACHMENT0);
    // osgviewer sets its own window up in this way: with the size and the distance of a screen.
    const osg::DisplaySettings& screen = *osg::DisplaySettings::instance();
    const double halfAngle = std::atan2(0.5 * static_cast<double>(screen.getScreenHeight()),
                                        static_cast<double>(screen.getScreenDistance()));
    camera->setProjectionMatrixAsPerspective(osg::RadiansToDegrees(2.0 * halfAngle),
                                             static_cast<double>(width) / height, 1.0, 10000.0);
    osgUtil::Optimizer().optimize(scene);
    viewer_->setSceneData(scene);
    viewer_->realize();
}

Screen ViewerTwin::frame()
{
    osg::GLExtensions::Get(window_->getState()->getContextID(), true)
        ->glBindFramebuffer(GL_FRAMEBUFFER, offscreen_.framebuffer());
    viewer_->frame();
    const std::vector<float> pixels = offscreen_.readPixels();
    Screen screen;
    screen.width = offscreen_.width();
    screen.height = offscreen_.height();
    for (int y = screen.height - 1; y >= 0; --y)
        for (int x = 0; x < screen.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const float value = pixels[static_cast<size_t>((y * screen.width + x) * 4 + c)];
                screen.rgb.push_back(static_cast<unsigned char>(std::lround(255.0f * value)));
            }
    return screen;
}

void ViewerTwin::zoomOverTerrain()
{
    osgGA::EventQueue& events = *viewer_->getEventQueue();
    events.keyPress('4');
    events.keyRelease('4');
    for (int i = 0; i < 2; ++i) events.mouseScroll(osgGA::GUIEventAdapter::SCROLL_DOWN);
    frame();
}

}  // namespace fbrdf::test
