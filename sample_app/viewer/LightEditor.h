// LightEditor.h - what mouse and keys of a window do to the lights of a document.
#pragma once
#include "World.h"

#include <fbrdf/scene/Controls.h>
#include <fbrdf/scene/LightEdit.h>

namespace fbrdf::viewer {

class LightEditor {
public:
    /// Both must outlive this. The world's lights are those of the document as they are drawn.
    LightEditor(scene::ViewState& state, const World& world) : state_(state), world_(world) {}

    /// Takes what the lights are seen from, and finds their handles: none where they are not shown,
    /// and none of more lights than one can tell apart.
    void see(const gl::View& view, int width, int height);
    const std::vector<scene::LightHandle>& handles() const { return handles_; }

    /// A button went down at a pixel. True where there is a handle: the light is selected, and
    /// follows drag() from then on.
    bool press(const glm::dvec2& pixel);
    void drag(const glm::dvec2& pixel);
    /// Fulfils the wishes of keys and panel: to add, remove and move lights.
    void follow();

private:
    int selected() const;
    scene::LightSet& listed();
    void move(int light, const Vec3d& place);
    void push(const Vec3d& steps);

    scene::ViewState& state_;
    const World& world_;
    std::vector<scene::LightHandle> handles_;
    gl::View view_;
    int width_ = 1, height_ = 1;
    glm::dvec2 grip_{0.0};  ///< of the mouse, from the middle of the handle
};

}  // namespace fbrdf::viewer
