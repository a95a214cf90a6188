#include "GlfwWindow.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cctype>

namespace fbrdf::viewer {
namespace {

constexpr double kScrollPause = 0.4;  // seconds after which turns of the wheel have ended

[[noreturn]] void fail(const char* step)
{
    const char* description = nullptr;
    glfwGetError(&description);
    throw Error(ErrorKind::gl, "window",
                Found(std::string(description ? description : "no reason") + " (" + step + ")")
                    .expected("a display with OpenGL 3.3; without one use --headless"));
}

GlfwWindow* windowOf(GLFWwindow* handle)
{
    return static_cast<GlfwWindow*>(glfwGetWindowUserPointer(handle));
}

/// 0 for other keys.
char namedKey(int key)
{
    switch (key) {
        case GLFW_KEY_LEFT: return scene::kLeftKey;
        case GLFW_KEY_RIGHT: return scene::kRightKey;
        case GLFW_KEY_UP: return scene::kUpKey;
        case GLFW_KEY_DOWN: return scene::kDownKey;
        case GLFW_KEY_PAGE_UP: return scene::kPageUpKey;
        case GLFW_KEY_PAGE_DOWN: return scene::kPageDownKey;
        case GLFW_KEY_KP_ENTER:
        case GLFW_KEY_ENTER: return scene::kEnterKey;
        case GLFW_KEY_DELETE: return scene::kDeleteKey;
        default: return 0;
    }
}

}  // namespace

GlfwWindow::GlfwWindow(int width, int height, const std::string& title, scene::ViewState& state)
    : state_(state)
{
    if (!glfwInit()) fail("glfwInit");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);  // the scene has a framebuffer of its own
    window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
    if (!window_) {
        try {
            fail("glfwCreateWindow");
        } catch (...) {
            glfwTerminate();
            throw;
        }
    }
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    installCallbacks();
}

GlfwWindow::~GlfwWindow()
{
    glfwDestroyWindow(window_);
    glfwTerminate();
}

gl::LoadFunction GlfwWindow::loader()
{
    return
        [](void*, const char* name) { return reinterpret_cast<void*>(glfwGetProcAddress(name)); };
}

void GlfwWindow::installCallbacks()
{
    glfwSetWindowUserPointer(window_, this);
    // Keys are recognised by character, so that every keyboard layout works; escape and F1 have no
    // character.
    glfwSetCharCallback(window_, [](GLFWwindow* handle, unsigned code) {
        GlfwWindow& self = *windowOf(handle);
        const bool taken = self.filter_.takesKeys && self.filter_.takesKeys();
        if (!taken && code < 128) self.key(static_cast<char>(std::tolower(static_cast<int>(code))));
    });
    glfwSetKeyCallback(window_, [](GLFWwindow* handle, int key, int code, int action, int mods) {
        if (action == GLFW_RELEASE) return;
        GlfwWindow& self = *windowOf(handle);
        const bool taken = self.filter_.takesKeys && self.filter_.takesKeys();
        const char* const name = glfwGetKeyName(key, code);  // by the layout
        if (!taken && name && (mods & GLFW_MOD_CONTROL) != 0)
            self.controlKey(name[0], (mods & GLFW_MOD_SHIFT) != 0);
        if (const char named = taken ? char(0) : namedKey(key)) self.key(named);
        if (action != GLFW_PRESS) return;
        if (key == GLFW_KEY_ESCAPE) self.key(27);
        if (key == GLFW_KEY_F1) self.key('h');
    });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* handle, int button, int action, int) {
        GlfwWindow& self = *windowOf(handle);
        if (button != GLFW_MOUSE_BUTTON_LEFT) return;
        self.isTaken_ = false;
        if (action == GLFW_PRESS) self.press();
    });
    glfwSetCursorPosCallback(
        window_, [](GLFWwindow* handle, double x, double y) { windowOf(handle)->drag(x, y); });
    glfwSetDropCallback(window_, [](GLFWwindow* handle, int count, const char** paths) {
        auto& dropped = windowOf(handle)->state_.dropped;
        dropped.insert(dropped.end(), paths, paths + count);
    });
    glfwSetScrollCallback(window_, [](GLFWwindow* handle, double, double steps) {
        GlfwWindow& self = *windowOf(handle);
        if (!self.filter_.takesMouse || !self.filter_.takesMouse()) self.scroll(steps);
    });
}

void GlfwWindow::drag(double x, double y)
{
    const bool taken = filter_.takesMouse && filter_.takesMouse();
    if (isTaken_) {
        filter_.drag(pixelAt(x, y));
    } else if (!taken && glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS) {
        int height = 1;
        glfwGetWindowSize(window_, nullptr, &height);
        applyDrag(state_, x - lastX_, y - lastY_, height);
    }
    lastX_ = x;
    lastY_ = y;
}

void GlfwWindow::key(char key)
{
    if (applyKey(state_, key) && filter_.afterKey) filter_.afterKey();
}

void GlfwWindow::controlKey(char key, bool withShift)
{
    if (applyControlKey(state_, key, withShift) && filter_.afterKey) filter_.afterKey();
}

glm::dvec2 GlfwWindow::pixelAt(double x, double y) const
{
    Size window{1, 1};
    glfwGetWindowSize(window_, &window.width, &window.height);
    const Size pixels = framebufferSize();
    return {x * pixels.width / std::max(1, window.width),
            y * pixels.height / std::max(1, window.height)};
}

void GlfwWindow::press()
{
    const bool taken = filter_.takesMouse && filter_.takesMouse();
    if (taken || !filter_.press) return;
    double x = 0.0, y = 0.0;
    glfwGetCursorPos(window_, &x, &y);
    isTaken_ = filter_.press(pixelAt(x, y));
}

void GlfwWindow::scroll(double steps)
{
    applyScroll(state_, steps);
    lastScroll_ = glfwGetTime();
}

bool GlfwWindow::isHeld() const
{
    for (const int button : {GLFW_MOUSE_BUTTON_LEFT, GLFW_MOUSE_BUTTON_RIGHT})
        if (glfwGetMouseButton(window_, button) == GLFW_PRESS) return true;
    return lastScroll_ && glfwGetTime() - *lastScroll_ < kScrollPause;
}

GlfwWindow::Size GlfwWindow::framebufferSize() const
{
    Size size{1, 1};
    glfwGetFramebufferSize(window_, &size.width, &size.height);
    return {std::max(1, size.width), std::max(1, size.height)};  // 0 while minimised
}

bool GlfwWindow::shouldClose() const
{
    return glfwWindowShouldClose(window_) || state_.close;
}

void GlfwWindow::present()
{
    glfwSwapBuffers(window_);
}

void GlfwWindow::takeInput(bool isStill, double rest)
{
    constexpr double kStillSeconds = 1.0 / 60.0;
    const double end = glfwGetTime() + rest;
    for (double left = rest; left > 0.0; left = end - glfwGetTime()) glfwWaitEventsTimeout(left);
    if (isStill)
        glfwWaitEventsTimeout(kStillSeconds);
    else
        glfwPollEvents();
}

}  // namespace fbrdf::viewer
