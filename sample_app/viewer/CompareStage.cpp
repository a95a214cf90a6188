#include "CompareStage.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <string_view>
#include <thread>
#include <utility>

namespace fbrdf::viewer {
namespace {

constexpr const char* kSvd = "svd";

/// Of a side that is singular values with a number of terms; nothing for others.
std::optional<int> svdTerms(const CompareSide& side)
{
    const std::string_view name = side.name, svd = kSvd;
    if (side.kind != CompareSide::Kind::form || name.substr(0, svd.size()) != svd) return {};
    int terms = 0;
    const char* const end = name.data() + name.size();
    const auto read = std::from_chars(name.data() + svd.size(), end, terms);
    return read.ec == std::errc() && read.ptr == end ? std::optional(terms) : std::nullopt;
}

/// The number of a side in a list, to which it is added where it is new.
int placeOf(const CompareSide& side, std::vector<CompareSide>& sides)
{
    const auto known = std::find(sides.begin(), sides.end(), side);
    const auto place = static_cast<int>(known - sides.begin());
    if (known == sides.end()) sides.push_back(side);
    return place;
}

/// Pictures are measured when they are new, twice as good, or finished.
bool isWorthMeasuring(int samples, int wanted)
{
    return samples > 0 && (samples >= wanted || (samples & (samples - 1)) == 0);
}

}  // namespace

CompareStage::CompareStage(gl::LoadFunction load, const Options& options, World& world,
                           GlScene& scene)
    : load_(load),
      options_(options),
      world_(world),
      scene_(scene),
      mapper_(load),
      sides_(offeredSides()),
      lookUp_(options.document.lookUp),
      precise_(options.document.precise)
{
    for (Seat& seat : seats_) seat.options = options;
}

/// Singular values are one side, whose terms are counted.
scene::Comparison CompareStage::comparisonOf(const scene::CompareView& view) const
{
    const auto nameOf = [&](int number) {
        const CompareSide& side = sides_[static_cast<size_t>(number)];
        return svdTerms(side) ? kSvd + std::to_string(view.terms) : side.name;
    };
    return {view.on, view.mode, nameOf(view.a), nameOf(view.b), view.at, view.gain, view.holds};
}

void CompareStage::take(const scene::Comparison& comparison, scene::CompareView& view)
{
    const std::array<CompareSide, 2> wanted{compareSideFromName(comparison.a),
                                            compareSideFromName(comparison.b)};
    for (const CompareSide& side : wanted)
        if (const std::optional<int> terms = svdTerms(side)) {
            view.terms = std::min(*terms, scene::kMostCompareTerms);
            nameSvd(view.terms);
        }
    view.a = placeOf(wanted[0], sides_);
    view.b = placeOf(wanted[1], sides_);
    view.sideCount = static_cast<int>(sides_.size());
    view.on = comparison.on;
    view.mode = comparison.mode;
    view.at = comparison.at;
    view.gain = comparison.gain;
    view.holds = comparison.holds;
}

void CompareStage::sync(scene::CompareView& view, scene::Comparison& document)
{
    if (!synced_ || !(document == *synced_)) try {
            take(document, view);
        } catch (const Error&) {
            if (!synced_) throw;
            document = *synced_;
            throw;
        }
    document = comparisonOf(view);
    synced_ = document;
}

void CompareStage::nameSvd(int terms)
{
    for (CompareSide& side : sides_)
        if (svdTerms(side)) side.name = kSvd + std::to_string(terms);
}

void CompareStage::follow(scene::CompareView& view, MaterialSlot& shown)
{
    nameSvd(view.terms);
    if (offeredFor_ != &shown || offeredSource_ != shown.source().get()) {
        offeredFor_ = &shown;
        offeredSource_ = shown.source().get();
        facts_.offers.clear();
        for (const CompareSide& side : sides_)
            facts_.offers.push_back({titleOf(side), whyNot(side, shown)});
    }
    followUpload();
    for (size_t i = 0; i < 2; ++i) {
        Seat& seat = seats_[i];
        const CompareSide& side = sides_[static_cast<size_t>(i == 0 ? view.a : view.b)];
        if (!(side == seat.side) || seat.source != shown.source().get()) {
            if (!(side == seat.side)) {
                seat.worker.stop();
                seat.firstOrder = 0;
                seat.side = side;
                seat.slot.reset();
                seat.uploaded.reset();
                ++seat.revision;
                seat.note.clear();
            }
            orderFor(seat, shown);
        }
        const std::string problem = whyNotHere(side);
        if (!problem.empty() || !seat.side.needsFit()) seat.problem = problem;
        takeFor(seat);
        if (!seat.slot) seat.note = noteOf(side, shown);
        fillFacts(static_cast<int>(i));
    }
}

/// Uploads anew where maps are to be looked up in another way.
void CompareStage::followUpload()
{
    const scene::Document& document = options_.document;
    if (lookUp_ == document.lookUp && precise_ == document.precise) return;
    lookUp_ = document.lookUp;
    precise_ = document.precise;
    for (Seat& seat : seats_)
        if (seat.uploaded) seat.uploaded = scene_.uploaded(seat.slot->material());
}

void CompareStage::orderFor(Seat& seat, const MaterialSlot& shown)
{
    seat.source = shown.source().get();
    seat.problem = whyNot(seat.side, shown);
    seat.order = 0;
    if (!seat.problem.empty()) {
        seat.slot.reset();
        seat.uploaded.reset();
        return;
    }
    if (auto order = orderOf(seat.side, shown)) seat.order = seat.worker.order(std::move(*order));
    if (seat.firstOrder == 0) seat.firstOrder = seat.order;
}

void CompareStage::takeFor(Seat& seat)
{
    const auto reply = seat.worker.take();
    if (!reply || seat.order == 0 || reply->number < seat.firstOrder) return;
    // While a slider is dragged, those before the last order are shown as well.
    if (reply->number == seat.order) seat.order = 0;
    seat.problem = reply->error;
    if (!reply->error.empty()) return;
    seat.slot = std::make_unique<MaterialSlot>(slotOf(seat.side, *reply));
    seat.uploaded = reply->material ? scene_.uploaded(*reply->material) : nullptr;
    seat.note = reply->note;
    seat.fitSeconds = reply->seconds;
    ++seat.revision;
}

void CompareStage::cancel()
{
    for (Seat& seat : seats_) {
        if (seat.order == 0) continue;
        seat.worker.stop();
        seat.order = 0;
        seat.problem = "the fit was stopped";
    }
}

std::string CompareStage::whyNotHere(const CompareSide& side) const
{
    const bool isVertex = side.kind == CompareSide::Kind::technique &&
                          side.name == viewTechniqueName(scene::ViewTechnique::vertex);
    if (!isVertex || !world_.environment || options_.frames) return "";
    return side.name + ": " +
           Found("an environment, whose sum at every vertex takes minutes")
               .expected("none (key E)");
}

scene::ViewTechnique CompareStage::techniqueNow(const Seat& seat, scene::ViewTechnique chosen) const
{
    const MaterialSlot& slot = seat.slot ? *seat.slot : world_.materials.front();
    return techniqueOf(seat.standsIn() ? CompareSide{} : seat.side, slot, chosen);
}

bool CompareStage::isOnCpu(scene::ViewTechnique chosen) const
{
    return std::any_of(seats_.begin(), seats_.end(), [&](const Seat& seat) {
        return scene::isOnCpu(techniqueNow(seat, chosen));
    });
}

Shown CompareStage::shownOf(Seat& seat, const CompareScene& scene) const
{
    Shown shown = scene.shown;
    shown.technique = seat.technique = techniqueNow(seat, shown.technique);
    seat.options = options_;  // with the document of now
    if (seat.standsIn() || !seat.slot) return shown;
    shown.made = {seat.slot.get(), seat.uploaded.get(), seat.revision};
    shown.instance.material = 0;
    return shown;
}

bool CompareStage::drawSeat(int side, const CompareScene& scene, bool isStale,
                            ToneMapper& toneMapper)
{
    Seat& seat = seats_[static_cast<size_t>(side)];
    const Shown shown = shownOf(seat, scene);
    if (!seat.progressive)
        seat.progressive = std::make_unique<Progressive>(load_, seat.options, world_, scene_);
    Progressive& progressive = *seat.progressive;
    const bool waits = scene.isHeld && progressive.hasShown(shown);
    const bool moved = !waits && progressive.draw(shown, scene.isBusy, seat.stats).has_value();
    const bool isNew = scene::isOnCpu(shown.technique) ? progressive.tookNewImage() : moved;
    if (!isNew && !isStale) return moved;
    ++pictures_;
    const gl::Target target = mapper_.seat(side, scene.target.width, scene.target.height);
    if (!scene::isOnCpu(shown.technique)) {
        toneMapper.show(target, progressive.sum(), scene.look);
    } else {
        toneMapper.upload(progressive.image());
        toneMapper.showUploaded(target, scene.look);
    }
    return true;
}

bool CompareStage::draw(const scene::CompareView& view, const CompareScene& scene,
                        ToneMapper& toneMapper)
{
    const Filled wanted{scene.look.exposure, scene.look.toneMap, scene.target.width,
                        scene.target.height};
    const bool isStale = !(wanted == filled_);
    filled_ = wanted;
    facts_.seconds = scene.seconds;
    bool moved = false;
    for (const int side : {0, 1}) {
        moved = drawSeat(side, scene, isStale, toneMapper) || moved;
        fillFacts(side);
    }
    measure(scene);
    mapper_.show(scene.target,
                 {view.mode, view.lineAt(scene.seconds), view.gain, view.flipsToB(scene.seconds)});
    return moved;
}

void CompareStage::fillFacts(int side)
{
    Seat& seat = seats_[static_cast<size_t>(side)];
    CompareFacts::Seat& facts = facts_.seats[static_cast<size_t>(side)];
    facts.title = titleOf(seat.side);
    facts.doing = seat.order > 0 ? seat.worker.doing() : "";
    if (seat.order > 0 && facts.doing.empty()) facts.doing = "fitted";
    facts.standsIn = seat.standsIn();
    facts.problem = seat.problem;
    facts.technique = viewTechniqueName(seat.technique);
    facts.note = seat.note;
    facts.bytes = seat.slot && seat.slot->hasMaterial() ? materialBytes(seat.slot->material()) : 0;
    if (!seat.progressive) return;
    facts.samples = seat.progressive->samples();
    facts.samplesWanted = samplesOf(options_, seat.technique);
}

/// The numbers of what there is so far, on a thread.
void CompareStage::measure(const CompareScene& scene)
{
    if (measuring_.valid()) {
        if (measuring_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
        facts_.numbers = numbersText(measuring_.get());
    }
    for (size_t i = 0; i < 2; ++i) {
        const CompareFacts::Seat& facts = facts_.seats[i];
        if (facts.standsIn || !facts.doing.empty() || seats_[i].progressive->isCoarse()) {
            facts_.numbers.clear();
            return;
        }
        if (!isWorthMeasuring(facts.samples, facts.samplesWanted)) return;
    }
    if (pictures_ == measuredPictures_) return;
    measuredPictures_ = pictures_;
    const Exposing exposing{scene.look.exposure, transferOf(options_.document)};
    measuring_ = std::async(std::launch::async,
                            [a = seats_[0].progressive->soFar(), b = seats_[1].progressive->soFar(),
                             exposing] { return compareNumbers(a, b, exposing); });
}

std::array<CursorSubject, 2> CompareStage::subjects(const scene::CompareView& view,
                                                    MaterialSlot& shown, int revision)
{
    std::array<CursorSubject, 2> subjects;
    for (size_t i = 0; i < 2; ++i) {
        const Seat& seat = seats_[i];
        const CompareSide reference =
            compareSideFromName(viewTechniqueName(scene::ViewTechnique::reference));
        const bool isThere = view.on && !seat.standsIn();
        const CompareSide side =
            view.on ? (isThere ? seat.side : CompareSide{}) : (i == 0 ? CompareSide{} : reference);
        MaterialSlot& slot = isThere && seat.slot ? *seat.slot : shown;
        const bool isTrue = side.kind == CompareSide::Kind::technique || !slot.hasMaterial();
        CursorSubject& subject = subjects[i];
        subject.title = titleOf(side);
        subject.revision = 65536 * seat.revision + revision;
        if (isTrue && slot.truthIsSource()) {
            subject.brdf = slot.truth();
            continue;
        }
        subject.material = &slot.material();
        subject.brdf = [&drawn = *subject.material](const Vec3d& wo, const Vec3d& wi) {
            return evaluate<double>(drawn, wo, wi);
        };
    }
    return subjects;
}

void CompareStage::wait()
{
    for (Seat& seat : seats_) {
        while (seat.order > 0) {
            takeFor(seat);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        if (!seat.problem.empty()) throw Error(ErrorKind::usage, "--compare", seat.problem);
    }
}

ComparePair CompareStage::finishedPair(const scene::CompareView& view, const Exposing& exposing,
                                       scene::CompareStats& stats)
{
    std::array<scene::Image, 2> images;
    std::array<scene::CompareSideStats, 2> sides;
    for (size_t i = 0; i < 2; ++i) {
        const Seat& seat = seats_[i];
        const CompareFacts::Seat& facts = facts_.seats[i];
        images[i] = seat.progressive->finishedImage();
        sides[i] = {seat.side.name, facts.technique,     facts.note,
                    facts.bytes,    facts.samplesWanted, seat.fitSeconds};
    }
    stats = {sides[0], sides[1], compareModeName(view.mode),
             compareNumbers(images[0], images[1], exposing)};
    for (size_t i = 0; i < 2; ++i)
        addBackground(options_, world_, seats_[i].progressive->shown().view, images[i]);
    return {std::move(images[0]),  std::move(images[1]),  exposing,
            facts_.seats[0].title, facts_.seats[1].title, numbersText(stats.numbers)};
}

scene::Image CompareStage::composedNow(const scene::CompareView& view, const Exposing& exposing,
                                       double seconds, scene::Stats& stats)
{
    stats.compare.emplace();
    const ComparePair pair = finishedPair(view, exposing, *stats.compare);
    if (view.mode == scene::CompareMode::flip) return sideBySide(pair);
    return composed(pair, {view.mode, view.lineAt(seconds), view.gain});
}

}  // namespace fbrdf::viewer
