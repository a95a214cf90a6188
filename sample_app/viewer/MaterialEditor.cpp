#include "MaterialEditor.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/io/MaterialFile.h>

#include <fmt/core.h>

#include <algorithm>

namespace fbrdf::viewer {
namespace {

constexpr int kLobes = 2;
constexpr size_t kMeasured = 16384;    // samples that the errors of a fit are computed on
constexpr double kDropSeconds = 10.0;  // of the search for a form
constexpr size_t kKeptFits = 16;       // of a slot
// What is dropped is first fitted without any search.
constexpr const char* kQuickForm = "hdio";
constexpr double kQuickSmoothness = 1e-3;

fitting::FitOrder orderOf(const scene::SceneMaterial& recipe)
{
    fitting::FitOrder order;
    order.source = recipe.source;
    order.fit = fitOptionsOf(recipe);
    order.fit.heldOut = false;
    order.fit.measured = kMeasured;
    return order;
}

std::string resultOf(const fitting::FitReply& reply)
{
    const Material& material = *reply.material;
    return fmt::format("{}, {} bytes, median error {:.2g} %, {:.2f} s", material.form.name,
                       materialBytes(material), 100.0 * reply.summary.all.logMedian, reply.seconds);
}

/// The material of a document that is in the slot, or the end.
template <class Materials>
auto materialOf(int slot, Materials& materials)
{
    return std::find_if(materials.begin(), materials.end(),
                        [&](const scene::SceneMaterial& m) { return m.slot == slot; });
}

}  // namespace

MaterialEditor::MaterialEditor(World& world, std::function<void(size_t)> changed)
    : world_(world), changed_(std::move(changed))
{
}

void MaterialEditor::open(const std::string& spec)
{
    Opening opening;
    opening.recipe.source = spec;
    opening.isDropped = true;
    if (std::optional<Material> material = readIfMaterial(spec))
        ready_.emplace_back(std::move(opening), std::move(*material));
    else
        toOpen_.push_back(std::move(opening));
}

void MaterialEditor::cancel()
{
    toOpen_.clear();
    editing_.stop();
    openings_.stop();
}

/// The slot's material is what its recipe says when it is first seen.
MaterialEditor::Edit& MaterialEditor::editOf(const SceneMaterial& material)
{
    const auto slot = static_cast<size_t>(material.slot);
    const auto known = edits_.find(slot);
    if (known != edits_.end()) return known->second;
    Edit& edit = edits_[slot];
    edit.ordered = material;
    MaterialSlot& loaded = world_.materials[slot];
    keep(edit, {material, loaded.source(), loaded.material()});
    return edit;
}

void MaterialEditor::keep(Edit& edit, Fitted fitted)
{
    edit.fitted.push_front(std::move(fitted));
    if (edit.fitted.size() > kKeptFits) edit.fitted.pop_back();
}

/// What comes of the slot's orders is too late.
void MaterialEditor::dropOrders(size_t slot)
{
    for (auto order = orders_.begin(); order != orders_.end();)
        order = order->second.slot == slot ? orders_.erase(order) : std::next(order);
}

/// Takes a fit that there was; orders that are under way come too late. False where there is none.
bool MaterialEditor::restore(size_t slot, Edit& edit, const SceneMaterial& recipe)
{
    const auto known = std::find_if(edit.fitted.begin(), edit.fitted.end(),
                                    [&](const Fitted& fitted) { return fitted.recipe == recipe; });
    if (known == edit.fitted.end()) return false;
    dropOrders(slot);
    world_.materials[slot].replace(recipe.source, known->source, known->material);
    edit.ordered = recipe;
    edit.hasLobes = true;
    changed_(slot);
    return true;
}

void MaterialEditor::orderEdit(size_t slot, Edit& edit, const SceneMaterial& recipe, bool withLobes)
{
    fitting::FitOrder order = orderOf(recipe);
    // An environment lights nothing until there are lobes.
    withLobes = withLobes || world_.materials[slot].material().lobes.isEmpty();
    order.lobes = withLobes ? kLobes : 0;
    if (!withLobes && !order.fit.smoothness && edit.smoothness > 0.0)
        order.fit.smoothness = edit.smoothness;
    edit.number = editing_.order(std::move(order));
    edit.ordered = recipe;
    edit.hasLobes = withLobes;
    orders_[edit.number] = {slot, recipe, withLobes};
}

void MaterialEditor::followShown(SceneMaterial& material)
{
    if (material.slot < 0) return;
    const auto slot = static_cast<size_t>(material.slot);
    MaterialSlot& loaded = world_.materials[slot];
    if (!loaded.source()) return;
    Edit& edit = editOf(material);
    if (edit.ordered == material || restore(slot, edit, material)) return;
    const bool wasSearched = isSearched(fitOptionsOf(edit.ordered));
    if (wasSearched && material.form == edit.ordered.form)
        material.form = loaded.material().form.name;
    orderEdit(slot, edit, material, false);
}

void MaterialEditor::warm(const scene::Document& document)
{
    const SceneMaterial* const shown = shownMaterial(document);
    if (!shown || shown->slot < 0) return;
    const auto slot = static_cast<size_t>(shown->slot);
    MaterialSlot& loaded = world_.materials[slot];
    if (!loaded.source() || !loaded.material().lobes.isEmpty()) return;
    Edit& edit = editOf(*shown);
    if (edit.number == 0) orderEdit(slot, edit, *shown, true);
}

/// False, with the reason among the facts, where there is no material.
bool MaterialEditor::take(const fitting::FitReply& reply, const std::string& source)
{
    facts_.problem = reply.error;
    facts_.failed = reply.error.empty() ? "" : source;
    if (!reply.material) return false;
    facts_.result = resultOf(reply);
    return true;
}

void MaterialEditor::takeEdit()
{
    auto reply = editing_.take();
    if (!reply) return;
    const auto known = orders_.find(reply->number);
    if (known == orders_.end()) return;
    const Order order = known->second;
    orders_.erase(orders_.begin(), std::next(known));
    if (!take(*reply, order.recipe.source)) return;
    MaterialSlot& slot = world_.materials[order.slot];
    Edit& edit = edits_.at(order.slot);
    Material material = *reply->material;
    if (order.withLobes) keep(edit, {order.recipe, reply->source, material});
    // Those of the material before light it until its own are there.
    if (material.lobes.isEmpty()) material.lobes = slot.material().lobes;
    slot.replace(order.recipe.source, reply->source, std::move(material));
    changed_(order.slot);
    if (reply->number != edit.number) return;
    if (edit.hasLobes)
        edit.smoothness = reply->summary.smoothness;
    else
        orderEdit(order.slot, edit, order.recipe, true);
}

/// Puts a slot that is ready into the document.
void MaterialEditor::place(const Opening& opening, scene::Document& document)
{
    loaded_[opening.recipe.slot] = opening.recipe;
    changed_(static_cast<size_t>(opening.recipe.slot));
    if (opening.isDropped) {
        auto place = materialOf(opening.recipe.slot, document.materials);
        if (place == document.materials.end())
            place = document.materials.insert(place, opening.recipe);
        *place = opening.recipe;
        document.shown = static_cast<int>(place - document.materials.begin());
    }
    for (SceneMaterial& material : document.materials)
        if (material.slot < 0 && opening.recipe == material) material.slot = opening.recipe.slot;
}

/// The slot takes the material, and forgets what it was made of before.
void MaterialEditor::fill(size_t slot, const SceneMaterial& recipe,
                          std::shared_ptr<const Source> source, Material material)
{
    dropOrders(slot);
    Edit& edit = edits_[slot] = {};
    edit.ordered = recipe;
    keep(edit, {recipe, source, material});
    world_.materials[slot].replace(recipe.source, std::move(source), std::move(material));
}

/// A slot that was loaded from this, and that the document has for nothing else (a slider changes
/// what a model is); -1: there is none.
int MaterialEditor::slotFrom(const std::string& source, const scene::Document& document) const
{
    for (const auto& [slot, recipe] : loaded_) {
        const auto use = materialOf(slot, document.materials);
        if (recipe.source == source && (use == document.materials.end() || use->source == source))
            return slot;
    }
    return -1;
}

/// What was dropped takes the place of what was read from the same file before.
void MaterialEditor::add(Opening& opening, std::shared_ptr<const Source> source, Material material,
                         scene::Document& document)
{
    SceneMaterial& recipe = opening.recipe;
    if (opening.isDropped) recipe.slot = slotFrom(recipe.source, document);
    if (recipe.slot >= 0) {
        fill(static_cast<size_t>(recipe.slot), recipe, std::move(source), std::move(material));
    } else {
        world_.materials.emplace_back(recipe.source, std::move(source), std::move(material));
        recipe.slot = static_cast<int>(world_.materials.size()) - 1;
    }
    place(opening, document);
}

/// Takes what a search has found in the place of the quick fit, unless that was changed meanwhile.
void MaterialEditor::improve(const Opening& opening, const fitting::FitReply& reply,
                             scene::Document& document)
{
    const auto slot = static_cast<size_t>(opening.recipe.slot);
    const auto recipe = materialOf(opening.recipe.slot, document.materials);
    if (recipe == document.materials.end() || !(*recipe == opening.recipe)) return;
    // A search that ends by the clock may find another form the next time.
    recipe->form = reply.material->form.name;
    loaded_[opening.recipe.slot] = *recipe;
    fill(slot, *recipe, reply.source, *reply.material);
    changed_(slot);
}

void MaterialEditor::takeOpened(scene::Document& document)
{
    for (; !ready_.empty(); ready_.pop_front())
        add(ready_.front().first, nullptr, std::move(ready_.front().second), document);
    if (auto reply = openings_.take(); reply && opening_) {
        const bool isMade = take(*reply, opening_->recipe.source);
        if (isMade && opening_->isSearched)
            improve(*opening_, *reply, document);
        else if (isMade)
            add(*opening_, reply->source, *reply->material, document);
        else if (!opening_->isDropped)
            refused_.push_back(opening_->recipe);
        const bool goesOn = isMade && opening_->isDropped && !opening_->isSearched &&
                            isSearched(fitOptionsOf(opening_->recipe));
        if (goesOn) {
            opening_->isSearched = true;
            orderOpening();
        } else {
            opening_.reset();
        }
    }
    if (opening_ || toOpen_.empty()) return;
    opening_ = toOpen_.front();
    toOpen_.pop_front();
    orderOpening();
}

/// What was dropped is there in a second or two, though a search for its form takes ten.
void MaterialEditor::orderOpening()
{
    fitting::FitOrder order = orderOf(opening_->recipe);
    order.lobes = kLobes;
    if (opening_->isDropped) order.fit.seconds = kDropSeconds;
    if (opening_->isDropped && !opening_->isSearched && isSearched(order.fit)) {
        order.fit.form = kQuickForm;
        order.fit.smoothness = kQuickSmoothness;
    }
    openings_.order(std::move(order));
}

/// A slot that was loaded for this before; -1: there is none.
int MaterialEditor::slotOf(const SceneMaterial& wanted) const
{
    for (const auto& [slot, recipe] : loaded_)
        if (recipe == wanted) return slot;
    return -1;
}

/// Begins to load what is in the document and nowhere else: of a scene that was opened.
void MaterialEditor::load(scene::Document& document)
{
    const auto isKnown = [this](const SceneMaterial& wanted) {
        const auto is = [&](const SceneMaterial& m) { return m == wanted; };
        return (opening_ && is(opening_->recipe)) ||
               std::any_of(refused_.begin(), refused_.end(), is) ||
               std::any_of(toOpen_.begin(), toOpen_.end(),
                           [&](const Opening& waiting) { return is(waiting.recipe); });
    };
    for (SceneMaterial& wanted : document.materials) {
        if (wanted.slot >= 0) loaded_.emplace(wanted.slot, wanted);
        if (wanted.slot < 0) wanted.slot = slotOf(wanted);
        if (wanted.slot >= 0 || isKnown(wanted)) continue;
        try {
            if (std::optional<Material> material = readIfMaterial(wanted.source)) {
                world_.materials.emplace_back(wanted.source, nullptr, std::move(*material));
                wanted.slot = static_cast<int>(world_.materials.size()) - 1;
                changed_(world_.materials.size() - 1);
            } else {
                toOpen_.push_back({wanted, false});
            }
        } catch (const Error& error) {
            facts_.problem = error.what();
            facts_.failed = wanted.source;
            refused_.push_back(wanted);
        }
    }
}

void MaterialEditor::follow(scene::Document& document)
{
    takeEdit();
    takeOpened(document);
    load(document);
    if (SceneMaterial* const shown = shownMaterial(document)) followShown(*shown);
    facts_.doing = openings_.doing();
    if (facts_.doing.empty()) facts_.doing = editing_.doing();
}

}  // namespace fbrdf::viewer
