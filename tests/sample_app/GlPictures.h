// GlPictures.h - scenes drawn by the runtime on a headless context, as pictures; and materials made
// from formulas, so that tests need neither files nor a fitter.
#pragma once
#include <fbrdf/brdf/Material.h>
#include <fbrdf/headless/Context.h>
#include <fbrdf/scene/CpuRenderer.h>

namespace fbrdf::scene {

struct GlPicture {
    Image image;
    gl::DrawStats stats;
};

/// Draws on one context, which is kept.
class GlPictures {
public:
    explicit GlPictures(Backend backend);
    /// scene.brdfs are not used; all instances are of `material`.
    GlPicture draw(const Scene& scene, const Material& material, Technique technique, int width,
                   int height);

private:
    HeadlessContext context_;
    gl::Renderer renderer_;
};

/// True where a context of this kind can be made; tests skip otherwise.
bool hasBackend(Backend backend);

/// Smooth, coloured, glossy and, where the form can be, anisotropic; log8 as fitted ones.
Material madeMaterial(const Form& form);

/// The material in double, as a scene wants it. `material` must outlive the result.
Brdf brdfOf(const Material& material);

}  // namespace fbrdf::scene
