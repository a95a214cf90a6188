#include "ProgramCache.h"

#include <fbrdf/base/Error.h>

#include <algorithm>
#include <functional>
#include <iterator>

namespace fbrdf::gl {
namespace {

/// A program that calls what a shadow hook must define.
std::string shadowProbe(const std::string& hook, int glsl)
{
    SurfaceInputs inputs;
    inputs.shadowHook = hook;
    Form form;
    form.terms.emplace_back();
    ProgramSpec spec;
    spec.parts = {{0, {}, false}};
    spec.lit = true;
    spec.lightSlots = 1;
    return fragmentSource(form, {}, spec, glsl, inputs);
}

bool isSame(const Part& a, const Part& b)
{
    return a.term == b.term && a.scaled == b.scaled && a.factors == b.factors;
}

bool isSame(const ProgramSpec& a, const ProgramSpec& b)
{
    return a.lightSlots == b.lightSlots && a.lit == b.lit && a.reads == b.reads &&
           a.transfer == b.transfer && a.gained == b.gained && a.clustered == b.clustered &&
           a.lobes == b.lobes && a.areaLists == b.areaLists && a.resolved == b.resolved &&
           a.toSurface == b.toSurface &&
           std::equal(a.parts.begin(), a.parts.end(), b.parts.begin(), b.parts.end(),
                      [](const Part& x, const Part& y) { return isSame(x, y); });
}

// Addresses are used again by the next object; numbers of hooks and materials are not.
uint64_t idOf(const CompiledHooks* hooks)
{
    return hooks ? hooks->id() : 0;
}

template <class Map>
void eraseExpiredOf(Map& map)
{
    for (auto i = map.begin(); i != map.end();)
        i = i->second.expired() ? map.erase(i) : std::next(i);
}

}  // namespace

bool ProgramCache::Known::isFor(const ProgramSpec& wanted, const SurfaceOptions& surface) const
{
    return hooks == idOf(surface.hooks) && normalMap == (surface.normalMap != 0) &&
           derivedTangent == surface.derivedTangent && isSame(spec, wanted);
}

const Program& ProgramCache::find(const MaterialResources& material, const ProgramSpec& spec,
                                  const SurfaceOptions& surface)
{
    Entry& entry = entryOf(material, spec, surface);
    entry.lastUse = draws_;
    if (!entry.program)
        throw Error(ErrorKind::gl, "material '" + material.name() + "'", entry.failure);
    return *entry.program;
}

ProgramCache::Entry& ProgramCache::entryOf(const MaterialResources& material,
                                           const ProgramSpec& spec, const SurfaceOptions& surface)
{
    // Texts are long, and making one costs more than a draw: a material remembers its programs.
    auto& known = known_[material.id()];
    const auto found = std::find_if(known.begin(), known.end(), [&](const Known& candidate) {
        return candidate.isFor(spec, surface);
    });
    if (found != known.end()) return *found->entry;
    const int glsl = device_->capabilities.glsl;
    const SurfaceInputs inputs = surface.inputs(material.isPacked());
    // Another material may have the same text.
    const auto entry = shared(
        material, {vertexSource(glsl, inputs),
                   fragmentSource(material.form(), material.encodings(), spec, glsl, inputs)});
    known.push_back(
        {idOf(surface.hooks), surface.normalMap != 0, surface.derivedTangent, spec, entry});
    return *entry;
}

std::shared_ptr<ProgramCache::Entry> ProgramCache::shared(const MaterialResources& material,
                                                          const Text& text)
{
    // The map does not own: a program lives as long as materials know it.
    std::weak_ptr<Entry>& place = entries_[text];
    if (auto entry = place.lock()) return entry;
    const auto entry = std::make_shared<Entry>();
    build(*entry, material, text);
    place = entry;
    return entry;
}

void ProgramCache::build(Entry& entry, const MaterialResources& material, const Text& text)
{
    try {
        entry.vertexShader = vertexShader(text.vertex);
        entry.program = std::make_unique<const Program>(
            linkedProgram(device_, material, *entry.vertexShader, text.fragment));
    } catch (const Error& error) {
        // Remembered, so that a text that fails is not compiled in every draw.
        entry.failure = error.what();
    }
}

std::shared_ptr<const Object> ProgramCache::vertexShader(const std::string& text)
{
    std::weak_ptr<const Object>& place = vertexShaders_[text];
    if (auto shader = place.lock()) return shader;
    const auto shader =
        std::make_shared<const Object>(compiledShader(device_, GL_VERTEX_SHADER, text));
    place = shader;
    return shader;
}

void ProgramCache::check(const Hooks& hooks)
{
    SurfaceInputs inputs;
    inputs.vertexHook = hooks.vertex;
    const int glsl = device_->capabilities.glsl;
    try {
        // Nothing is linked: which material the hooks will meet is not known yet.
        compiledShader(device_, GL_VERTEX_SHADER, vertexSource(glsl, inputs));
        if (!hooks.shadow.empty())
            compiledShader(device_, GL_FRAGMENT_SHADER, shadowProbe(hooks.shadow, glsl));
    } catch (const Error& error) {
        throw Error(ErrorKind::input, "hooks", error.what());
    }
}

// This must cost nothing where nothing has gone.
void ProgramCache::evict()
{
    if (++draws_ % kIdleDraws == 0) evictIdle();
    if (device_->retiredMaterials.empty() && device_->retiredHooks.empty()) return;
    for (const uint64_t id : device_->retiredMaterials) {
        const auto gone = known_.find(id);
        if (gone == known_.end()) continue;
        for (Known& known : gone->second) release(std::move(known.entry));
        known_.erase(gone);
    }
    evictHooks();
    device_->retiredMaterials.clear();
    device_->retiredHooks.clear();
    eraseExpired();
}

// The maps do not own, so what is left in them now are places of programs that are gone.
void ProgramCache::eraseExpired()
{
    eraseExpiredOf(entries_);
    eraseExpiredOf(vertexShaders_);
}

template <class IsGone, class Take>
void ProgramCache::forget(const IsGone& isGone, const Take& take)
{
    for (auto& [id, known] : known_) {
        const auto gone = std::stable_partition(known.begin(), known.end(), std::not_fn(isGone));
        std::for_each(gone, known.end(), [&](Known& one) { take(std::move(one.entry)); });
        known.erase(gone, known.end());
    }
}

// Who tries every technique on every material would keep a program of each.
void ProgramCache::evictIdle()
{
    std::vector<uint64_t> uses;
    for (const auto& [text, place] : entries_)
        if (const auto entry = place.lock(); entry && entry->lastUse + kIdleDraws <= draws_)
            uses.push_back(entry->lastUse);
    if (uses.size() <= mostIdle_) return;
    const auto last = uses.end() - static_cast<std::ptrdiff_t>(mostIdle_) - 1;
    std::nth_element(uses.begin(), last, uses.end());
    forget([&](const Known& known) { return known.entry->lastUse <= *last; },
           [](const std::shared_ptr<Entry>&) {});
    eraseExpired();
}

void ProgramCache::evictHooks()
{
    const auto& retired = device_->retiredHooks;
    if (retired.empty()) return;
    const auto isGone = [&](const Known& known) {
        return std::find(retired.begin(), retired.end(), known.hooks) != retired.end();
    };
    forget(isGone, [this](std::shared_ptr<Entry> entry) { release(std::move(entry)); });
}

void ProgramCache::release(std::shared_ptr<Entry> entry)
{
    // Failures are forgotten, so that the next material tries again.
    // A program whose last material has gone is kept for a while: replacing a material by one of
    // the same form, frame after frame, would otherwise compile each time.
    if (entry.use_count() > 1 || !entry->program) return;
    unused_.push_back(std::move(entry));
    if (unused_.size() > kMostUnused) unused_.pop_front();
}

}  // namespace fbrdf::gl
