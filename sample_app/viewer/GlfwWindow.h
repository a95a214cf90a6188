// GlfwWindow.h - a window with an OpenGL 3.3 core context, and what is done in it.
#pragma once
#include <fbrdf/gl/Renderer.h>
#include <fbrdf/scene/Controls.h>

#include <glm/vec2.hpp>

#include <functional>
#include <optional>
#include <string>

struct GLFWwindow;

namespace fbrdf::viewer {

/// Who else is interested in the input.
struct InputFilter {
    std::function<bool()> takesMouse, takesKeys;  ///< true: something else (the panel) wants it
    /// The left button goes down at a pixel of the framebuffer. True: the drag that begins goes to
    /// `drag` instead of turning the view.
    std::function<bool(const glm::dvec2& pixel)> press;
    std::function<void(const glm::dvec2& pixel)> drag;
    std::function<void()> afterKey;  ///< a key has changed the state; several may come in a frame
};

class GlfwWindow {
public:
    /// Keys, drags and the wheel change `state`, which must outlive the window. Throws Error(gl)
    /// where there is no display or no OpenGL 3.3.
    GlfwWindow(int width, int height, const std::string& title, scene::ViewState& state);
    ~GlfwWindow();
    GlfwWindow(const GlfwWindow&) = delete;
    GlfwWindow& operator=(const GlfwWindow&) = delete;

    GLFWwindow* handle() const { return window_; }
    void setFilter(InputFilter filter) { filter_ = std::move(filter); }
    static gl::LoadFunction loader();

    struct Size {
        int width, height;
    };
    Size framebufferSize() const;  ///< pixels, >= 1
    /// True while a button is down or the wheel turns: what that changes is one change.
    bool isHeld() const;
    bool shouldClose() const;
    /// Shows what was drawn.
    void present();
    /// isStill: waits for some, a short while. rest: takes what comes for so many seconds before.
    void takeInput(bool isStill, double rest);

private:
    void installCallbacks();
    void key(char key);
    void controlKey(char key, bool withShift);
    void press();
    glm::dvec2 pixelAt(double x, double y) const;
    void drag(double x, double y);
    void scroll(double steps);

    GLFWwindow* window_ = nullptr;
    scene::ViewState& state_;
    InputFilter filter_;
    bool isTaken_ = false;  ///< the drag goes to the filter
    double lastX_ = 0.0, lastY_ = 0.0;
    std::optional<double> lastScroll_;  ///< seconds of GLFW's clock
};

}  // namespace fbrdf::viewer
