#include "Scene.h"

namespace fbrdf::tool {

Scene measureScene(const BrdfFunction& brdf, const BrdfFunction& reference, int threads)
{
    constexpr int kSize = 256;  // the standard sphere's
    Scene scene;
    scene.physics = physicsErrors(brdf, threads);
    if (!reference) return scene;
    scene.picture = renderStandardSphere(brdf, kSize, threads);
    scene.reference = renderStandardSphere(reference, kSize, threads);
    scene.image = imageErrors(scene.picture, scene.reference);
    return scene;
}

ErrorMap errorMap(const Scene& scene)
{
    ErrorMap errors = errorMap(scene.physics);
    if (scene.image) errors.merge(errorMap(*scene.image));
    return errors;
}

}  // namespace fbrdf::tool
