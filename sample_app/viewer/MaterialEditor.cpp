#include "MaterialEditor.h"

#include <fbrdf/io/MaterialFile.h>

#include <fmt/core.h>

namespace fbrdf::viewer {
namespace {

constexpr int kLobes = 2;
constexpr size_t kMeasured = 16384;  // samples that the errors of a fit are computed on

/// What is fitted again and again has a form that is named: searching one takes seconds.
std::string formOf(const MaterialSlot& slot, const Material& material)
{
    const FitOptions& options = *slot.fitOptions();
    return isSearched(options) ? material.form.name : options.form;
}

FitFields fieldsOf(MaterialSlot& slot)
{
    FitFields fields;
    if (namesModel(slot.name())) fields.model = parseModelSpec(slot.name());
    fields.form = formOf(slot, slot.material());
    if (const auto& smoothness = slot.fitOptions()->smoothness) {
        fields.choosesSmoothness = false;
        fields.smoothness = static_cast<float>(*smoothness);
    }
    return fields;
}

fitting::FitOrder orderOf(const std::string& source, const FitFields& fields)
{
    fitting::FitOrder order;
    order.source = source;
    order.fit.form = fields.form;
    order.fit.resolution = fields.resolution;
    order.fit.maxBytes = 1024 * static_cast<size_t>(fields.kilobytes);
    if (!fields.choosesSmoothness) order.fit.smoothness = static_cast<double>(fields.smoothness);
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

}  // namespace

bool FitFields::operator==(const FitFields& o) const
{
    return model.has_value() == o.model.has_value() &&
           (!model || (model->model == o.model->model && model->values == o.model->values)) &&
           form == o.form && resolution == o.resolution &&
           choosesSmoothness == o.choosesSmoothness && smoothness == o.smoothness &&
           kilobytes == o.kilobytes;
}

MaterialEditor::MaterialEditor(World& world, std::function<void(size_t)> changed)
    : world_(world), changed_(std::move(changed))
{
}

MaterialEditor::Edit* MaterialEditor::editOf(size_t slot)
{
    if (!world_.materials[slot].fitOptions()) return nullptr;
    const auto known = edits_.find(slot);
    if (known != edits_.end()) return &known->second;
    Edit edit;
    edit.fields = edit.ordered = fieldsOf(world_.materials[slot]);
    edit.hasLobes = true;
    return &edits_.emplace(slot, std::move(edit)).first->second;
}

FitFields* MaterialEditor::fields(size_t slot)
{
    Edit* const edit = editOf(slot);
    return edit ? &edit->fields : nullptr;
}

void MaterialEditor::open(const std::string& spec)
{
    if (std::optional<Material> material = readIfMaterial(spec)) {
        world_.materials.emplace_back(spec, nullptr, std::move(*material));
        changed_(world_.materials.size() - 1);
        return;
    }
    toOpen_.push_back(spec);
}

void MaterialEditor::cancel()
{
    toOpen_.clear();
    editing_.stop();
    openings_.stop();
}

void MaterialEditor::orderEdit(size_t slot, Edit& edit, bool withLobes)
{
    const std::string source =
        edit.fields.model ? modelSpecText(*edit.fields.model) : world_.materials[slot].name();
    fitting::FitOrder order = orderOf(source, edit.fields);
    // An environment lights nothing until there are lobes.
    withLobes = withLobes || world_.materials[slot].material().lobes.isEmpty();
    order.lobes = withLobes ? kLobes : 0;
    if (!withLobes && !order.fit.smoothness && edit.smoothness > 0.0)
        order.fit.smoothness = edit.smoothness;
    edit.number = editing_.order(std::move(order));
    edit.ordered = edit.fields;
    edit.hasLobes = withLobes;
    slotOf_[edit.number] = slot;
}

/// False, with the reason among the facts, where there is no material.
bool MaterialEditor::take(fitting::FitReply& reply)
{
    facts_.problem = reply.error;
    if (!reply.material) return false;
    facts_.result = resultOf(reply);
    return true;
}

void MaterialEditor::takeEdit()
{
    auto reply = editing_.take();
    if (!reply) return;
    const size_t index = slotOf_.at(reply->number);
    slotOf_.erase(slotOf_.begin(), slotOf_.upper_bound(reply->number));
    if (!take(*reply)) return;
    MaterialSlot& slot = world_.materials[index];
    Material material = *reply->material;
    // Those of the material before light it until its own are there.
    if (material.lobes.isEmpty()) material.lobes = slot.material().lobes;
    const std::string spec = namesModel(slot.name()) ? reply->source->name : slot.name();
    slot.replace(spec, reply->source, std::move(material));
    changed_(index);
    Edit& edit = edits_.at(index);
    if (reply->number != edit.number) return;
    if (edit.hasLobes)
        edit.smoothness = reply->summary.smoothness;
    else
        orderEdit(index, edit, true);
}

void MaterialEditor::takeOpened()
{
    if (auto reply = openings_.take()) {
        if (take(*reply)) {
            world_.materials.emplace_back(opening_, reply->source, *reply->material);
            changed_(world_.materials.size() - 1);
        }
        opening_.clear();
    }
    if (!opening_.empty() || toOpen_.empty()) return;
    opening_ = toOpen_.front();
    toOpen_.pop_front();
    fitting::FitOrder order;
    order.source = opening_;
    order.fit.seconds = 10.0;
    order.lobes = kLobes;
    openings_.order(std::move(order));
}

void MaterialEditor::follow(size_t slot)
{
    takeEdit();
    takeOpened();
    Edit* const edit = editOf(slot);
    if (edit && !(edit->fields == edit->ordered)) orderEdit(slot, *edit, false);
    facts_.doing = openings_.doing();
    if (facts_.doing.empty()) facts_.doing = editing_.doing();
}

}  // namespace fbrdf::viewer
