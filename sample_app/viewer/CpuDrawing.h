// CpuDrawing.h - a picture that the CPU draws, sample by sample.
#pragma once
#include "World.h"

#include <fbrdf/truth/Occluders.h>
#include <fbrdf/truth/PathTracer.h>

#include <limits>
#include <memory>

namespace fbrdf::viewer {

/// What is drawn. `instances` use the meshes of a world and its materials.
struct CpuRequest {
    scene::ViewTechnique technique = scene::ViewTechnique::reference;  ///< one on the CPU
    std::vector<scene::Instance> instances;
    gl::View view;
    int width = 0, height = 0;
    MaterialSlot* only = nullptr;  ///< all instances are made of it; null: of the world's materials
};

class CpuDrawing {
public:
    /// Materials that are sources are fitted where the technique needs it. The world must outlive
    /// this.
    CpuDrawing(const Options& options, World& world, CpuRequest request);

    bool isFinished() const { return left_ == 0; }
    int samples() const { return done_; }  ///< of each pixel, so far
    /// Adds the next sample of every pixel; of `path` only as much of it as is done in about so
    /// many milliseconds, which samples() counts when it is complete.
    void goOn(double milliseconds = std::numeric_limits<double>::infinity());
    /// What there is so far, and of `path` what is known about it.
    scene::Image image() const;
    std::optional<scene::PathStats> pathStats() const;

private:
    CpuRequest request_;
    scene::Scene scene_;
    std::optional<truth::Occluders> occluders_;  ///< of the shadows of all but `path`
    int bounces_ = 0, done_ = 0, left_ = 1;
    std::unique_ptr<truth::PathTracer> tracer_;
    scene::Image sum_;  ///< of the samples of all but `path`
};

/// Techniques of the CPU, without any GL.
Picture drawOnCpu(const Options& options, World& world);

}  // namespace fbrdf::viewer
