// MaterialEditor.h - materials that follow sliders, and those that are dropped on the window: they
// are fitted on threads while the window goes on drawing what there is.
#pragma once
#include "World.h"

#include <fbrdf/fitting/FitWorker.h>
#include <fbrdf/sources/Model.h>

#include <deque>
#include <functional>
#include <map>
#include <string>

namespace fbrdf::viewer {

/// What sliders change of a material that is fitted.
struct FitFields {
    std::optional<ModelSpec> model;  ///< none: a measurement, whose data stay
    std::string form;
    int resolution = 0;             ///< 0: the form's own
    bool choosesSmoothness = true;  ///< by the error held out; false: as below
    float smoothness = 1e-3f;
    int kilobytes = 0;  ///< no material larger than this; 0: no limit

    bool operator==(const FitFields& other) const;
};

/// What is known about the last fit, for people.
struct FitFacts {
    std::string doing;    ///< what a thread does; empty: none does anything
    std::string problem;  ///< why the last fit failed; empty: it did not
    std::string result;   ///< error, bytes and seconds of the last fit
};

class MaterialEditor {
public:
    /// Calls `changed(slot)` where a material of the world has changed or has been added. The world
    /// must outlive this.
    MaterialEditor(World& world, std::function<void(size_t slot)> changed);

    /// The fields of a slot, which may be changed at will; null where it is a material file.
    FitFields* fields(size_t slot);
    /// Fits a file or model, and adds it to the world; a material file is added at once. Throws
    /// what reading a material file throws.
    void open(const std::string& spec);
    /// Gives up what is being fitted, and what waits for it.
    void cancel();
    /// Orders what has changed of the fields of a slot, and takes what is ready. Once a frame.
    void follow(size_t slot);
    const FitFacts& facts() const { return facts_; }

private:
    /// Of a slot that sliders have changed.
    struct Edit {
        FitFields fields, ordered;
        int number = 0;         ///< of the last order
        bool hasLobes = false;  ///< that order asks for them
        /// That the last whole fit chose: those that follow a slider do not choose again. 0: none.
        double smoothness = 0.0;
    };
    Edit* editOf(size_t slot);
    void orderEdit(size_t slot, Edit& edit, bool withLobes);
    void takeEdit();
    void takeOpened();
    bool take(fitting::FitReply& reply);

    World& world_;
    std::function<void(size_t)> changed_;
    std::map<size_t, Edit> edits_;
    std::map<int, size_t> slotOf_;  ///< by the number of the order, of orders without a reply
    std::deque<std::string> toOpen_;
    std::string opening_;  ///< what openings_ fits; empty: nothing
    FitFacts facts_;
    fitting::FitWorker editing_, openings_;
};

}  // namespace fbrdf::viewer
