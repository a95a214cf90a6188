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
    PathTrace(const scene::Scene& scene, std::vector<LobeTable> lobes, const PathOptions& options);

    /// An estimate, without bias, of the radiance that leaves a fragment towards the eye.
    Vec3d radiance(const scene::Fragment& seen, Random& random) const;
    Vec3d positionOf(const scene::Fragment& fragment) const
    {
        return rays_.pointOf(fragment).position;
    }

private:
    /// A point of a path, and what it is made of.
    struct Vertex {
        scene::SurfacePoint point;
        Vec3d departure, wo;
        ShadingFrame<double> frame;
        const scene::Brdf* brdf;
        const LobeTable* lobes;
        bool seesSky;  ///< false: its share of the environment is known
    };
    /// Where a path goes on: f cos over the density, and the density.
    struct Step {
        Ray ray;
        Vec3d weight{0.0};
        double pdf = 0.0;  ///< 0: it ends
    };
    Vertex vertexAt(const scene::Fragment& fragment, const Vec3d& toViewer) const;
    Step stepFrom(const Vertex& vertex, Random& random) const;
    bool isBlocked(const Vertex& vertex, const Vec3d& direction, double distance) const
    {
        return shadows_ && rays_.isBlocked({vertex.departure, direction}, distance);
    }
    Vec3d fromLights(const Vertex& vertex) const;
    Vec3d fromEmitters(const Vertex& vertex, Random& random) const;
    Vec3d reflected(const Vertex& vertex, const Emission& emission) const;
    Vec3d emittedAlong(const Vertex& vertex, const Step& step, double blocked) const;
    double shareOfLights(double lightPdf, double materialPdf) const;

    const scene::Scene& scene_;
    std::vector<LobeTable> lobes_;
    int bounces_;
    LightSearch search_;
    bool shadows_;
    scene::Eye eye_;
    RayScene rays_;
    std::vector<AreaEmitter> areas_;
    std::optional<EnvironmentEmitter> environment_;
    Vec3d sky_{0.0};  ///< irradiance of an open ground
};

}  // namespace fbrdf::truth
