#include "Boundary.h"
#include "Lights.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

using namespace fbrdf::capi;

namespace {

// What version 0.1 began with; fields after it are younger.
constexpr size_t kFirstDraw = offsetof(fbrdf_draw_desc, max_lights);

/// Element `index` of a caller's array, whose elements may be of another version.
template <class T>
T elementAt(const T* array, uint32_t size, size_t index)
{
    T element{};
    std::memcpy(&element, reinterpret_cast<const unsigned char*>(array) + index * size,
                std::min<size_t>(size, sizeof element));
    return element;
}

template <class T>
void checkArray(const T* array, uint32_t count, uint32_t size, const char* name)
{
    if (count == 0) return;
    required(array, name);
    if (size < sizeof(T))
        throw Failure(FBRDF_ERROR_VERSION, std::string(name) + ": found elements of " +
                                               std::to_string(size) + " bytes, expected " +
                                               std::to_string(sizeof(T)));
}

std::vector<fbrdf::gl::Item> itemsOf(const fbrdf_draw_desc& desc)
{
    checkArray(desc.items, desc.item_count, desc.item_size, "items");
    std::vector<fbrdf::gl::Item> items;
    for (size_t i = 0; i < desc.item_count; ++i) {
        const fbrdf_item item = elementAt(desc.items, desc.item_size, i);
        items.push_back({item.material ? item.material->gpu.get() : nullptr,
                         item.mesh ? item.mesh->gpu.get() : nullptr, glm::make_mat4(item.model)});
    }
    return items;
}

std::vector<fbrdf::Light> lightsOf(const fbrdf_draw_desc& desc)
{
    checkArray(desc.lights, desc.light_count, desc.light_size, "lights");
    std::vector<fbrdf::Light> lights;
    for (size_t i = 0; i < desc.light_count; ++i)
        lights.push_back(lightOf(elementAt(desc.lights, desc.light_size, i)));
    return lights;
}

int countOf(uint32_t value, int otherwise, const char* name)
{
    constexpr uint32_t kMost = 1u << 30;
    if (value > kMost)
        throw Failure(FBRDF_ERROR_ARGUMENT, std::string(name) + ": found " + std::to_string(value) +
                                                ", expected at most " + std::to_string(kMost));
    return value == 0 ? otherwise : static_cast<int>(value);
}

fbrdf::gl::DrawOptions optionsOf(const fbrdf_draw_desc& desc)
{
    fbrdf::gl::DrawOptions options;
    options.technique = enumerator(desc.technique, fbrdf::Technique::twoLookup, "technique");
    options.lightsPerPass = countOf(desc.lights_per_pass, 8, "lights_per_pass");
    options.maxLookups = countOf(desc.max_lookups, 0, "max_lookups");
    options.maxLights = countOf(desc.max_lights, 0, "max_lights");
    options.clustered = desc.clustered != 0;
    return options;
}

fbrdf::gl::Target targetOf(const fbrdf_draw_desc& desc)
{
    return {desc.framebuffer, desc.width, desc.height,
            enumerator(desc.transfer, fbrdf::Transfer::toneMap, "transfer"),
            desc.exposure == 0.0f ? 1.0f : desc.exposure};
}

void report(const fbrdf::gl::DrawStats& from, fbrdf_draw_stats* to)
{
    const auto count = [](int value) { return static_cast<uint32_t>(value); };
    fbrdf_draw_stats stats{};
    stats.struct_size = to->struct_size;
    stats.passes = count(from.passes);
    stats.draw_calls = count(from.drawCalls);
    stats.items_failed = count(from.itemsFailed);
    stats.lights_given = count(from.lightsGiven);
    stats.lights_used = count(from.lightsUsed);
    stats.lights_dropped = count(from.lightsDropped);
    stats.lights_culled = count(from.lightsCulled);
    stats.max_lookups = count(from.maxLookups);
    from.accumulation.copy(stats.accumulation, sizeof stats.accumulation - 1);
    std::memcpy(to, &stats, std::min<size_t>(to->struct_size, sizeof stats));
}

}  // namespace

fbrdf_result fbrdf_draw(fbrdf_renderer* renderer, const fbrdf_draw_desc* desc,
                        fbrdf_draw_stats* stats)
{
    return guarded(renderer ? &renderer->shared->log : nullptr, [&] {
        Shared& shared = *required(renderer, "renderer").shared;
        const fbrdf_draw_desc known = descriptor(desc, kFirstDraw, "draw");
        if (stats && stats->struct_size < offsetof(fbrdf_draw_stats, draw_calls))
            throw Failure(FBRDF_ERROR_VERSION, "stats: found struct_size " +
                                                   std::to_string(stats->struct_size) +
                                                   ", expected room for a number at least");
        const fbrdf::gl::View view{glm::make_mat4(known.view), glm::make_mat4(known.projection)};
        const auto drawn = shared.renderer.draw(targetOf(known), view, itemsOf(known),
                                                lightsOf(known), optionsOf(known));
        if (stats) report(drawn, stats);
    });
}
