// MaterialEditor.h - materials that follow the document: they are fitted on threads while the
// window goes on drawing what there is.
#pragma once
#include "World.h"

#include <fbrdf/fitting/FitWorker.h>

#include <deque>
#include <functional>
#include <map>
#include <string>

namespace fbrdf::viewer {

/// What is known about the last fit, for people.
struct FitFacts {
    std::string doing;    ///< what a thread does; empty: none does anything
    std::string problem;  ///< why the last fit failed; empty: it did not
    std::string failed;   ///< the source of that fit
    std::string result;   ///< error, bytes and seconds of the last fit
};

class MaterialEditor {
public:
    /// Calls `changed(slot)` where a material of the world has changed or has been added. The world
    /// must outlive this.
    MaterialEditor(World& world, std::function<void(size_t slot)> changed);

    /// Fits a file or model, and adds it to the document as soon as there is a quick fit; the
    /// search for the best form goes on. A material file is added with the next follow(). What was
    /// read from the same file before is replaced. Throws what reading a material file throws.
    void open(const std::string& spec);
    /// Gives up what is being fitted, and what waits for it.
    void cancel();
    /// Takes what is ready, loads materials of the document that have no slot yet, and orders a fit
    /// where the one that is shown is fitted in another way than it was. Where its form was
    /// searched, it becomes the one that was found: searching again takes seconds. Once a frame.
    void follow(scene::Document& document);
    /// Fits what is shown once more where it was fitted without lobes, as a program begins: the
    /// next fits follow a slider at once, with its lobes and the smoothness that was chosen.
    void warm(const scene::Document& document);
    const FitFacts& facts() const { return facts_; }

private:
    using SceneMaterial = scene::SceneMaterial;
    struct Fitted {
        SceneMaterial recipe;
        std::shared_ptr<const Source> source;
        Material material;
    };
    /// Of a slot that is fitted.
    struct Edit {
        SceneMaterial ordered;  ///< what the last order, or the material itself, was made of
        int number = 0;         ///< of the last order
        bool hasLobes = true;   ///< that order asks for them
        /// That the last whole fit chose: those that follow a slider do not choose again. 0: none.
        double smoothness = 0.0;
        std::deque<Fitted> fitted;  ///< whole fits that there were, so that undo need not wait
    };
    struct Order {
        size_t slot = 0;
        SceneMaterial recipe;
        bool withLobes = false;
    };
    struct Opening {
        SceneMaterial recipe;
        bool isDropped = false;  ///< to be added to the document; else it is in there
        /// Shown as a quick fit, while a form is searched for it.
        bool isSearched = false;
    };

    Edit& editOf(const SceneMaterial& material);
    void keep(Edit& edit, Fitted fitted);
    void dropOrders(size_t slot);
    bool restore(size_t slot, Edit& edit, const SceneMaterial& recipe);
    void orderEdit(size_t slot, Edit& edit, const SceneMaterial& recipe, bool withLobes);
    void followShown(SceneMaterial& material);
    int slotOf(const SceneMaterial& wanted) const;
    int slotFrom(const std::string& source, const scene::Document& document) const;
    void load(scene::Document& document);
    void takeEdit();
    void takeOpened(scene::Document& document);
    void orderOpening();
    void fill(size_t slot, const SceneMaterial& recipe, std::shared_ptr<const Source> source,
              Material material);
    void add(Opening& opening, std::shared_ptr<const Source> source, Material material,
             scene::Document& document);
    void improve(const Opening& opening, const fitting::FitReply& reply, scene::Document& document);
    void place(const Opening& opening, scene::Document& document);
    bool take(const fitting::FitReply& reply, const std::string& source);

    World& world_;
    std::function<void(size_t)> changed_;
    std::map<int, SceneMaterial> loaded_;  ///< by slots: what each was loaded for
    std::map<size_t, Edit> edits_;
    std::map<int, Order> orders_;  ///< by their numbers; those without a reply
    std::deque<Opening> toOpen_;
    std::deque<std::pair<Opening, Material>> ready_;  ///< material files
    std::optional<Opening> opening_;                  ///< what openings_ fits
    std::vector<SceneMaterial> refused_;  ///< of the document, which could not be loaded
    FitFacts facts_;
    fitting::FitWorker editing_, openings_;
};

}  // namespace fbrdf::viewer
