// Progressive.h - the picture of a window: coarse or of one sample while things change, better from
// frame to frame while they stand still, and then left alone.
#pragma once
#include "CpuDrawing.h"
#include "FrameTimer.h"
#include "GlScene.h"
#include "SampleSum.h"

#include <memory>
#include <optional>
#include <utility>

namespace fbrdf::viewer {

/// What an object is made of, where that is no material of the world: a slot, and its maps where
/// the runtime draws them.
struct Made {
    MaterialSlot* slot = nullptr;  ///< null: a material of the world
    gl::GpuMaterial* uploaded = nullptr;
    int revision = 0;
};

/// What a picture depends on.
struct Shown {
    gl::View view;
    scene::ViewTechnique technique = scene::ViewTechnique::reference;
    scene::Instance instance;
    int width = 0, height = 0;
    int revision = 0;  ///< of all that was replaced in the world, or in how it is drawn
    Made made = {};

    bool operator==(const Shown& o) const;
};

class Progressive {
public:
    /// Belongs to the context that is current. What is given must outlive this.
    Progressive(gl::LoadFunction load, const Options& options, World& world, GlScene& scene);

    /// Goes on with the picture, or begins it anew where something has changed: as many samples as
    /// are done in a short frame, or, where frames are counted, all. Returns the milliseconds that
    /// took, nothing where the picture was finished. Fills the fields of the stats that say how.
    /// isBusy: something else needs the processor; a slow picture then stays coarse.
    std::optional<double> draw(const Shown& wanted, bool isBusy, scene::Stats& stats);

    bool hasShown(const Shown& wanted) const { return shown_ && *shown_ == wanted; }
    bool isCoarse() const { return coarse_; }
    bool isSlow() const;  ///< a whole sample takes so long that pictures that move are coarse
    const Shown& shown() const { return *shown_; }  ///< expects draw() before
    int samples() const;                            ///< of each pixel, so far
    /// Of techniques of the runtime.
    const SampleSum& sum() const { return sum_; }
    /// Of those of the CPU; true for each picture once.
    bool tookNewImage() { return std::exchange(hasNewImage_, false); }
    const scene::Image& image() const { return image_; }
    /// Of all, with the samples that there are; expects one.
    scene::Image soFar() const;

    /// The picture with all its samples; draws what is missing of them.
    scene::Image finishedImage();

private:
    int wantedSamples() const { return samplesOf(options_, shown_->technique); }
    void restartSum(bool coarse);
    void drawByRuntime(int samples, scene::Stats& stats);
    bool drawByCpu(bool changed, scene::Stats& stats);

    const Options& options_;
    World& world_;
    GlScene& scene_;
    SampleSum sum_;
    FrameTimer timer_;
    std::optional<Shown> shown_;
    double sampleMilliseconds_ = 0.0;  ///< of the runtime, in full size; 0: not known yet
    int sharpness_ = 0;                ///< of the environment that was drawn
    int step_;                         ///< one pixel in step x step is drawn while things change
    bool coarse_ = false, hasNewImage_ = false;
    std::unique_ptr<CpuDrawing> cpu_;
    scene::Image image_;  ///< of the CPU: its last complete sample, and those before
    scene::Stats spare_;  ///< of samples that nobody asks about
};

}  // namespace fbrdf::viewer
