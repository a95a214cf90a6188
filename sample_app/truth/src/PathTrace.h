// PathTrace.h - one path: from what a pixel sees on from surface to surface.
#pragma once
#include "Random.h"
#include "RayScene.h"

#include <fbrdf/brdf/ShadingFrame.h>
#include <fbrdf/truth/Emitters.h>
#include <fbrdf/truth/PathTracer.h>

#include <optional>

namespace fbrdf::truth {

/// A scene with its lights, ready for paths.
class PathTrace {
public:
    PathTrace(const scene::Scene& scene, std::vector<LobeTable> lobes, int bounces,
              LightSearch search);

    /// An estimate, without bias, of the radiance that leaves a fragment towards the eye.
    Vec3d radiance(const scene::Fragment& seen, Random& random) const;
    Vec3d positionOf(const scene::Fragment& fragment) const
    {
        return rays_.pointOf(fragment).position;
    }

private:
    /// A point of a path, and what it is made of.
    struct Vertex {
        Vec3d position, departure, wo;
        ShadingFrame<double> frame;
        const scene::Brdf* brdf;
        const LobeTable* lobes;
    };
    /// Where a path goes on: f cos over the density, and the density.
    struct Step {
        Ray ray;
        Vec3d weight{0.0};
        double pdf = 0.0;  ///< 0: it ends
    };
    Vertex vertexAt(const scene::Fragment& fragment, const Vec3d& toViewer) const;
    Step stepFrom(const Vertex& vertex, Random& random) const;
    Vec3d fromLights(const Vertex& vertex) const;
    Vec3d fromEmitters(const Vertex& vertex, Random& random) const;
    Vec3d reflected(const Vertex& vertex, const Emission& emission) const;
    Vec3d emittedAlong(const Vertex& vertex, const Step& step, double blocked) const;
    double shareOfLights(double lightPdf, double materialPdf) const;

    const scene::Scene& scene_;
    std::vector<LobeTable> lobes_;
    int bounces_;
    LightSearch search_;
    scene::Eye eye_;
    RayScene rays_;
    std::vector<AreaEmitter> areas_;
    std::optional<EnvironmentEmitter> environment_;
};

}  // namespace fbrdf::truth
