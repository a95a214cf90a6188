#include "Progressive.h"

#include "Headless.h"

#include <fbrdf/scene/SubPixels.h>

#include <algorithm>
#include <chrono>
#include <limits>

namespace fbrdf::viewer {
namespace {

// While the view changes, the CPU draws one pixel in 4 x 4, so that the mouse stays responsive.
constexpr int kCoarseStep = 4;
// As many samples are drawn in a frame as this allows: 40 frames a second, or one sample. Where one
// takes much longer, as without a GPU, the runtime draws one pixel in 2 x 2, or in 4 x 4, while
// things change.
constexpr double kWholeSample = std::numeric_limits<double>::infinity();
constexpr double kFrameMilliseconds = 25.0, kCpuMilliseconds = 50.0, kSlowMilliseconds = 80.0;
constexpr double kCoarseMilliseconds = 40.0;
constexpr int kLeastStep = 2, kMostStep = 4;
// Of a frame, while an environment comes.
constexpr double kRefineMilliseconds = 15.0, kBusyRefineMilliseconds = 5.0;

/// The step after a coarse picture that took so long: larger where that was too long, smaller where
/// as many more pixels would be quick enough.
int nextStep(int step, double milliseconds)
{
    constexpr double kEnough = 0.8;  // so that it does not go to and fro
    const double finer = step * step / static_cast<double>((step - 1) * (step - 1));
    if (milliseconds > kCoarseMilliseconds) return std::min(step + 1, kMostStep);
    if (finer * milliseconds < kEnough * kCoarseMilliseconds) return std::max(step - 1, kLeastStep);
    return step;
}

}  // namespace

bool Shown::operator==(const Shown& o) const
{
    return view.view == o.view.view && view.projection == o.view.projection &&
           technique == o.technique && instance.model == o.instance.model &&
           instance.material == o.instance.material && width == o.width && height == o.height &&
           revision == o.revision && made.slot == o.made.slot && made.revision == o.made.revision;
}

Progressive::Progressive(gl::LoadFunction load, const Options& options, World& world,
                         GlScene& scene)
    : options_(options), world_(world), scene_(scene), sum_(load), timer_(load), step_(kLeastStep)
{
    // What draws on the processor is slow until it has shown that it is not.
    if (scene.renderer().capabilities().softwareSampling)
        sampleMilliseconds_ = 2.0 * kSlowMilliseconds;
    if (!isOnCpu(options.document.technique))
        scene_.prepare(runtimeTechnique(options.document.technique), world);
}

bool Progressive::isSlow() const
{
    return sampleMilliseconds_ > kSlowMilliseconds;
}

int Progressive::samples() const
{
    if (!isOnCpu(shown_->technique)) return sum_.count();
    return coarse_ || !cpu_ ? 0 : cpu_->samples();
}

std::optional<double> Progressive::draw(const Shown& wanted, bool isBusy, scene::Stats& stats)
{
    // Lobes that are still being fitted change the picture when they are there.
    const bool waits = !isOnCpu(wanted.technique) && !stats.whyNoEnvironment.empty();
    if (shown_ && !isOnCpu(wanted.technique))
        scene_.refineEnvironment(isBusy ? kBusyRefineMilliseconds : kRefineMilliseconds);
    const bool sharpened = sharpness_ != scene_.sharpness() && !isOnCpu(wanted.technique);
    sharpness_ = scene_.sharpness();
    const bool changed = !shown_ || !(*shown_ == wanted) || waits || sharpened;
    shown_ = wanted;
    const auto start = std::chrono::steady_clock::now();
    if (isOnCpu(wanted.technique)) {
        if (!drawByCpu(changed, stats)) return std::nullopt;
        const std::chrono::duration<double, std::milli> time =
            std::chrono::steady_clock::now() - start;
        return time.count();
    }
    const bool isSlow = this->isSlow();
    if (isBusy && isSlow && !changed && !options_.frames) return std::nullopt;
    // A counted frame is drawn even where it shows the same, and is worth its full size.
    if (changed || coarse_ || options_.frames) restartSum(changed && !options_.frames && isSlow);
    const int missing = wantedSamples() - sum_.count();
    if (missing <= 0) return std::nullopt;
    const int affordable =
        sampleMilliseconds_ > 0.0 ? static_cast<int>(kFrameMilliseconds / sampleMilliseconds_) : 1;
    const int count = options_.frames ? missing : std::clamp(affordable, 1, missing);
    timer_.begin();
    drawByRuntime(count, stats);
    const double milliseconds = timer_.end();
    sampleMilliseconds_ = milliseconds / count * (coarse_ ? step_ * step_ : 1);
    if (coarse_) step_ = nextStep(step_, milliseconds);
    return milliseconds;
}

void Progressive::restartSum(bool coarse)
{
    coarse_ = coarse;
    const int step = coarse ? step_ : 1;
    sum_.restart(std::max(1, shown_->width / step), std::max(1, shown_->height / step),
                 options_.document.target);
}

void Progressive::drawByRuntime(int samples, scene::Stats& stats)
{
    GlRequest request{runtimeTechnique(shown_->technique),
                      {shown_->instance},
                      {},
                      &world_.lights,
                      world_.ground.get(),
                      0,
                      shown_->made.uploaded};
    for (int i = 0; i < samples; ++i) {
        const gl::Target target = sum_.clearedTarget();
        request.sample = sum_.count();
        request.step = coarse_ ? step_ : 1;
        request.view = scene::movedBy(shown_->view, scene::subPixel(request.sample), target.width,
                                      target.height);
        addDrawStats(scene_.draw(target, request), scene_.renderer(), stats);
        sum_.add();
    }
    stats.path.reset();
}

/// Draws coarsely while things change, in full once they stand still, sample by sample, and then
/// not at all. Returns whether it did.
bool Progressive::drawByCpu(bool changed, scene::Stats& stats)
{
    if (!changed && !coarse_ && cpu_->isFinished()) return false;
    const bool isCounted = options_.frames.has_value();  // a counted frame is worth its full size
    if (changed || coarse_) {
        coarse_ = changed && !isCounted;
        const int step = coarse_ ? kCoarseStep : 1;
        cpu_ = std::make_unique<CpuDrawing>(options_, world_,
                                            CpuRequest{shown_->technique,
                                                       {shown_->instance},
                                                       shown_->view,
                                                       std::max(1, shown_->width / step),
                                                       std::max(1, shown_->height / step),
                                                       shown_->made.slot});
    }
    const int before = cpu_->samples();
    const bool isWhole = isCounted || coarse_;
    cpu_->goOn(isWhole ? kWholeSample : kCpuMilliseconds);
    while (isCounted && !cpu_->isFinished()) cpu_->goOn();
    if (cpu_->samples() == before) return true;
    stats.accumulation = "double";
    stats.path = cpu_->pathStats();
    image_ = cpu_->image();
    hasNewImage_ = true;
    return true;
}

scene::Image Progressive::soFar() const
{
    return isOnCpu(shown_->technique) ? image_ : sum_.mean();
}

scene::Image Progressive::finishedImage()
{
    if (!isOnCpu(shown_->technique)) {
        scene_.finishEnvironment();
        if (coarse_ || sharpness_ != scene_.sharpness()) restartSum(false);
        sharpness_ = scene_.sharpness();
        drawByRuntime(wantedSamples() - sum_.count(), spare_);
        return sum_.mean();
    }
    while (coarse_ || cpu_->samples() == 0) drawByCpu(false, spare_);
    return image_;
}

}  // namespace fbrdf::viewer
