// CompareStage.h - a comparison in the window: two sides that are fitted on threads, drawn ever
// better, and laid over each other.
#pragma once
#include "CompareMapper.h"
#include "CompareSide.h"
#include "CursorInspector.h"
#include "Progressive.h"

#include <fbrdf/fitting/FitWorker.h>

#include <array>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fbrdf::viewer {

/// What people see of a comparison beside its picture.
struct CompareFacts {
    struct Offer {
        std::string title, whyNot;  ///< whyNot: of the material that is shown; empty: it has it
    };
    struct Seat {
        std::string title;
        std::string doing;    ///< what is being fitted
        std::string problem;  ///< why there is no such side
        std::string technique, note;
        bool standsIn = false;  ///< the material does, as long as there is no such side
        size_t bytes = 0;       ///< of maps; 0: none
        int samples = 0, samplesWanted = 0;
    };
    std::vector<Offer> offers;  ///< by the numbers of CompareView
    std::array<Seat, 2> seats;  ///< A, B
    double seconds = 0.0;       ///< CompareScene::seconds of the picture
    std::string numbers;        ///< of the newest pictures that were measured; empty: none were
};

/// What a window shows beside the sides: see Progressive.h and ToneMapper.h.
struct CompareScene {
    Shown shown;  ///< of the material that is shown, by the technique that is chosen
    Look look;
    gl::Target target;
    bool isBusy = false;   ///< something else is being fitted
    bool isHeld = false;   ///< the mouse holds something: pictures wait, so that it moves smoothly
    double seconds = 0.0;  ///< since any moment
};

class CompareStage {
public:
    /// Belongs to the context that is current. What is given must outlive this.
    CompareStage(gl::LoadFunction load, const Options& options, World& world, GlScene& scene);

    /// Brings a view in line with a document where that has changed since the last call, as by
    /// undo, and else the document in line with the view. Throws Error(usage) for a side that is
    /// none; the document then has what is shown again.
    void sync(scene::CompareView& view, scene::Comparison& document);
    /// Orders and takes what the sides of a view need of the material that is shown. Once a frame.
    void follow(scene::CompareView& view, MaterialSlot& shown);
    /// Gives up what is being fitted.
    void cancel();
    /// True where the CPU draws a side: pictures that turn would never be finished.
    bool isOnCpu(scene::ViewTechnique chosen) const;
    /// Goes on with both pictures, all their samples where frames are counted, and shows them.
    /// False where nothing moved.
    bool draw(const scene::CompareView& view, const CompareScene& scene, ToneMapper& toneMapper);

    const CompareFacts& facts() const { return facts_; }
    /// Both sides as functions; without a comparison the material as drawn, and the reference.
    std::array<CursorSubject, 2> subjects(const scene::CompareView& view, MaterialSlot& shown,
                                          int revision);
    /// Waits until both sides are there. Throws Error(usage) where one cannot be.
    void wait();

    /// Both pictures with all their samples, laid over each other as draw() showed them last, or of
    /// a flip side by side; stats get the numbers.
    scene::Image composedNow(const scene::CompareView& view, const Exposing& exposing,
                             double seconds, scene::Stats& stats);

private:
    scene::Comparison comparisonOf(const scene::CompareView& view) const;
    void nameSvd(int terms);
    void take(const scene::Comparison& comparison, scene::CompareView& view);
    ComparePair finishedPair(const scene::CompareView& view, const Exposing& exposing,
                             scene::CompareStats& stats);
    struct Seat {
        CompareSide side;
        const Source* source = nullptr;      ///< that was ordered for
        std::unique_ptr<MaterialSlot> slot;  ///< null: the shown material
        std::shared_ptr<gl::GpuMaterial> uploaded;
        std::string problem, note;
        double fitSeconds = 0.0;
        bool standsIn() const { return !problem.empty() || (!slot && side.needsFit()); }
        int order = 0;       ///< number; 0: nothing is awaited
        int firstOrder = 0;  ///< of this side; 0: there was none
        int revision = 0;    ///< of slot
        Options options;
        scene::Stats stats;
        scene::ViewTechnique technique = scene::ViewTechnique::reference;  ///< drawn last
        std::unique_ptr<Progressive> progressive;
        fitting::FitWorker worker;
    };
    void followUpload();
    void orderFor(Seat& seat, const MaterialSlot& shown);
    void takeFor(Seat& seat);
    bool drawSeat(int side, const CompareScene& scene, bool isStale, ToneMapper& toneMapper);
    scene::ViewTechnique techniqueNow(const Seat& seat, scene::ViewTechnique chosen) const;
    Shown shownOf(Seat& seat, const CompareScene& scene) const;
    std::string whyNotHere(const CompareSide& side) const;
    void fillFacts(int side);
    void measure(const CompareScene& scene);

    gl::LoadFunction load_;
    const Options& options_;
    World& world_;
    GlScene& scene_;
    CompareMapper mapper_;
    std::vector<CompareSide> sides_;  ///< by the numbers of CompareView
    std::optional<scene::Comparison> synced_;
    std::array<Seat, 2> seats_;
    const MaterialSlot* offeredFor_ = nullptr;
    const Source* offeredSource_ = nullptr;
    CompareFacts facts_;

    /// What the seats of the mapper were filled for.
    struct Filled {
        float exposure = 0.0f;
        bool toneMap = false;
        int width = 0, height = 0;
        bool operator==(const Filled& o) const
        {
            return exposure == o.exposure && toneMap == o.toneMap && width == o.width &&
                   height == o.height;
        }
    };
    Filled filled_;
    LookUp lookUp_;  ///< of the uploaded maps
    bool precise_;
    std::future<scene::CompareNumbers> measuring_;
    int pictures_ = 0, measuredPictures_ = 0;  ///< that were shown, and when the last was measured
};

}  // namespace fbrdf::viewer
