#include "PathTrace.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Parallel.h>
#include <fbrdf/scene/Ground.h>
#include <fbrdf/scene/SubPixels.h>

#include <algorithm>
#include <cmath>

namespace fbrdf::truth {

class PathTracer::State {
public:
    State(const scene::Scene& scene, std::vector<LobeTable> lobes, const PathOptions& options)
        : scene_(scene),
          options_(options),
          paths_(scene, std::move(lobes), options),
          pixels_(static_cast<size_t>(width()) * static_cast<size_t>(height()))
    {
    }

    int samples() const { return samples_; }
    /// Rows of the sample that is being traced; a new one is begun where the last is complete.
    void addRows(int count);
    int rowsLeft() const { return height() - row_; }
    PathPicture picture() const;

private:
    /// The mean of a pixel's samples, and the sum of their squared distances from it (Welford 1962,
    /// "Note on a Method for Calculating Corrected Sums of Squares and Products").
    struct Pixel {
        Vec3d mean{0.0}, squares{0.0};
        double covered = 0.0;

        void add(const Vec3d& radiance, int count)
        {
            const Vec3d before = radiance - mean;
            mean += before / static_cast<double>(count);
            squares += before * (radiance - mean);
        }
    };
    int width() const { return options_.picture.width; }
    int height() const { return options_.picture.height; }
    /// How much of what is behind the objects a fragment hides.
    double opacityOf(const scene::Fragment& fragment) const
    {
        return scene_.isGround(fragment) ? scene_.ground->opacity(paths_.positionOf(fragment))
                                         : 1.0;
    }

    const scene::Scene& scene_;
    PathOptions options_;
    PathTrace paths_;
    scene::Fragments seen_;
    std::vector<Pixel> pixels_;
    int samples_ = 0;  ///< that are complete
    int row_ = 0;      ///< of the sample that is being traced: the next
};

void PathTracer::State::addRows(int count)
{
    if (row_ == 0 && (samples_ == 0 || options_.spread)) {
        const Vec2<double> place = options_.spread ? scene::subPixel(samples_) : Vec2<double>(0.0);
        seen_ = rasterise(scene_.instances, scene::movedBy(scene_.view, place, width(), height()),
                          width(), height());
    }
    const auto columns = static_cast<size_t>(width());
    const int rows = std::min(count, height() - row_);
    parallelTasks(static_cast<size_t>(rows), options_.picture.threads, [&](size_t task) {
        const size_t row = static_cast<size_t>(row_) + task;
        for (size_t i = row * columns; i < (row + 1) * columns; ++i) {
            if (seen_.pixels[i].covered()) {
                Random random(options_.seed, i, static_cast<uint64_t>(samples_));
                const double opacity = opacityOf(seen_.pixels[i]);
                pixels_[i].add(opacity * paths_.radiance(seen_.pixels[i], random), samples_ + 1);
                pixels_[i].covered += opacity;
            } else {
                pixels_[i].add(Vec3d(0.0), samples_ + 1);
            }
        }
    });
    row_ += rows;
    if (row_ < height()) return;
    row_ = 0;
    ++samples_;
}

PathPicture PathTracer::State::picture() const
{
    PathPicture picture{scene::Image(width(), height()),
                        std::vector<Vec3f>(pixels_.size(), Vec3f(0.0f))};
    const size_t further = static_cast<size_t>(row_) * static_cast<size_t>(width());
    for (size_t i = 0; i < pixels_.size(); ++i) {
        // A mean of n samples varies n times less than they do, of which n - 1 degrees are free.
        const double count = samples_ + (i < further ? 1 : 0);
        if (count == 0.0) break;
        const double freedom = count * std::max(1.0, count - 1.0);
        float* const pixel = picture.image.rgba.data() + 4 * i;
        for (int c = 0; c < 3; ++c) {
            pixel[c] = static_cast<float>(pixels_[i].mean[c]);
            picture.error[i][c] = static_cast<float>(std::sqrt(pixels_[i].squares[c] / freedom));
        }
        pixel[3] = static_cast<float>(pixels_[i].covered / count);
    }
    return picture;
}

PathTracer::PathTracer(const scene::Scene& scene, std::vector<LobeTable> lobes,
                       const PathOptions& options)
    : state_(std::make_unique<State>(scene, std::move(lobes), options))
{
}

PathTracer::~PathTracer() = default;

void PathTracer::add(int samples)
{
    FBRDF_ASSERT(samples, >=, 0);
    for (int i = 0; i < samples; ++i) state_->addRows(state_->rowsLeft());
}

void PathTracer::addRows(int count)
{
    FBRDF_ASSERT(count, >, 0);
    state_->addRows(count);
}

int PathTracer::samples() const
{
    return state_->samples();
}

PathPicture PathTracer::picture() const
{
    return state_->picture();
}

double noiseOf(const PathPicture& picture)
{
    double errors = 0.0, radiances = 0.0;
    for (size_t i = 0; i < picture.error.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const auto error = static_cast<double>(picture.error[i][c]),
                       radiance =
                           static_cast<double>(picture.image.rgba[4 * i + static_cast<size_t>(c)]);
            errors += error * error;
            radiances += radiance * radiance;
        }
    return radiances > 0.0 ? std::sqrt(errors / radiances) : 0.0;
}

}  // namespace fbrdf::truth
