#include "Boundary.h"
#include "Lights.h"

#include <fbrdf/base/Found.h>

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <optional>

using namespace fbrdf::capi;

namespace {

std::vector<fbrdf::gl::Item> itemsOf(const fbrdf_draw_desc& desc)
{
    std::vector<fbrdf::gl::Item> items;
    // A material or mesh that is NULL goes on as such: the renderer leaves out that item and logs
    // it.
    for (const fbrdf_item& item : elements(desc.items, desc.item_count, desc.item_size, "items"))
        items.push_back({item.material ? item.material->gpu.get() : nullptr,
                         item.mesh ? item.mesh->gpu.get() : nullptr, glm::make_mat4(item.model),
                         item.hooks ? item.hooks->gpu.get() : nullptr, item.normal_map});
    return items;
}

fbrdf::gl::Batch batchOf(const fbrdf_batch_desc& desc)
{
    fbrdf::gl::Batch batch{desc.library ? desc.library->gpu.get() : nullptr,
                           desc.mesh ? desc.mesh->gpu.get() : nullptr,
                           {},
                           desc.hooks ? desc.hooks->gpu.get() : nullptr,
                           desc.normal_map};
    for (const fbrdf_instance& instance :
         elements(desc.instances, desc.instance_count, desc.instance_size, "instances")) {
        // An index that no int can represent is out of range in any library, as -1 is.
        const bool possible = instance.material <= INT32_MAX;
        batch.instances.push_back(
            {glm::make_mat4(instance.model), possible ? static_cast<int>(instance.material) : -1});
    }
    return batch;
}

std::vector<fbrdf::Light> lightsOf(const fbrdf_draw_desc& desc)
{
    std::vector<fbrdf::Light> lights;
    for (const fbrdf_light& light :
         elements(desc.lights, desc.light_count, desc.light_size, "lights"))
        lights.push_back(lightOf(light));
    return lights;
}

int countOf(uint32_t value, int otherwise, const char* name)
{
    // An int has room for it, and for sums with other such numbers.
    constexpr uint32_t kMost = 1u << 30;
    if (value > kMost)
        throw Failure(
            FBRDF_RESULT_ERROR_ARGUMENT,
            std::string(name) + ": " +
                fbrdf::Found(std::to_string(value)).expected("at most " + std::to_string(kMost)));
    return value == 0 ? otherwise : static_cast<int>(value);
}

fbrdf::gl::EnvironmentLight environmentOf(const fbrdf_environment_light& given)
{
    const fbrdf_environment_light light = descriptor(&given, "environment");
    fbrdf::gl::EnvironmentLight result;
    result.map = required(light.environment, "environment").gpu.get();
    result.rotation = fbrdf::gl::environmentRotation(light.rotation);
    result.intensity = {light.intensity[0], light.intensity[1], light.intensity[2]};
    result.lobes = countOf(light.lobes, 0, "lobes");
    result.samples = countOf(light.samples, 0, "samples");
    return result;
}

/// 0 leaves the choice to the planner; the others follow in the order of ColourFormat.
std::optional<fbrdf::ColourFormat> accumulationOf(uint32_t given)
{
    using fbrdf::ColourFormat;
    constexpr ColourFormat kFormats[] = {ColourFormat::rgba8, ColourFormat::rgba16,
                                         ColourFormat::rgba16f, ColourFormat::rgba32f};
    const auto format = enumerator(given, FBRDF_ACCUMULATION_RGBA32F, "accumulation");
    if (format == FBRDF_ACCUMULATION_AUTOMATIC) return {};
    return kFormats[format - FBRDF_ACCUMULATION_RGBA8];
}

fbrdf::gl::DrawOptions optionsOf(const fbrdf_draw_desc& desc)
{
    fbrdf::gl::DrawOptions options;
    options.technique = enumerator(desc.technique, fbrdf::allTechniques().back(), "technique");
    options.lightsPerPass = countOf(desc.lights_per_pass, 8, "lights_per_pass");
    options.maxLookups = countOf(desc.max_lookups, 0, "max_lookups");
    options.maxLights = countOf(desc.max_lights, 0, "max_lights");
    options.clustered = desc.clustered != 0;
    options.listsBy = enumerator(desc.lists_by, fbrdf::gl::ListsBy::gpu, "lists_by");
    options.accumulation = accumulationOf(desc.accumulation);
    if (desc.environment) options.environment = environmentOf(*desc.environment);
    for (const fbrdf_area_light& light :
         elements(desc.area_lights, desc.area_light_count, desc.area_light_size, "area_lights"))
        options.areaLights.push_back(areaLightOf(light));
    return options;
}

fbrdf::gl::Target targetOf(const fbrdf_draw_desc& desc)
{
    // 0 is the default of every field. An exposure of 0 would draw black, which nobody asks for.
    return {desc.framebuffer, desc.width, desc.height,
            enumerator(desc.transfer, fbrdf::Transfer::toneMap, "transfer"),
            desc.exposure == 0.0f ? 1.0f : desc.exposure};
}

fbrdf::gl::DepthOptions depthOf(const fbrdf_depth_desc* desc)
{
    fbrdf::gl::DepthOptions depth;
    if (!desc) return depth;
    const fbrdf_depth_desc known = descriptor(desc, "depth");
    depth.test = enumerator(known.test, fbrdf::gl::DepthTest::greaterEqual, "depth test");
    depth.clip = enumerator(known.clip, fbrdf::gl::ClipDepth::zeroToOne, "depth clip");
    depth.rangeLow = known.range_low;
    depth.rangeHigh = known.range_high;
    depth.clear = known.clear;
    return depth;
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
    stats.technique = static_cast<uint32_t>(from.technique);
    stats.error_relative = static_cast<float>(from.error.relative);
    stats.error_absolute = static_cast<float>(from.error.absolute);
    // The last byte stays 0: longer texts are cut, but always end.
    from.whyReplaced.copy(stats.why_replaced, sizeof stats.why_replaced - 1);
    stats.items_without_environment = count(from.itemsWithoutEnvironment);
    stats.environment_error = static_cast<float>(from.environmentError);
    from.whyNoEnvironment.copy(stats.why_no_environment, sizeof stats.why_no_environment - 1);
    from.whyNotSampled.copy(stats.why_not_sampled, sizeof stats.why_not_sampled - 1);
    stats.lists_by = static_cast<uint32_t>(from.listsBy);
    from.whyListsByCpu.copy(stats.why_lists_by_cpu, sizeof stats.why_lists_by_cpu - 1);
    from.accumulation.copy(stats.accumulation, sizeof stats.accumulation - 1);
    from.whyAccumulation.copy(stats.why_accumulation, sizeof stats.why_accumulation - 1);
    stats.filter = static_cast<uint32_t>(from.filter);
    stats.error_recombination = static_cast<float>(from.error.maps.recombination);
    stats.error_filtering = static_cast<float>(from.error.maps.filtering);
    stats.error_filtering_absolute = static_cast<float>(from.error.maps.absolute);
    // A newer caller has fields that this library does not know; they become 0.
    std::memset(to, 0, to->struct_size);
    std::memcpy(to, &stats, std::min<size_t>(stats.struct_size, sizeof stats));
}

/// Reads what every draw has, calls act(renderer, target, view, descriptor), which draws, and fills
/// the stats.
template <class Act>
fbrdf_result drawn(fbrdf_renderer* renderer, const fbrdf_draw_desc* desc, fbrdf_draw_stats* stats,
                   Act act)
{
    return guarded(logOf(renderer), [&] {
        Shared& shared = *required(renderer, "renderer").shared;
        const fbrdf_draw_desc known = descriptor(desc, "draw");
        // Checked before anything is drawn, so that a refused call leaves the picture alone.
        if (stats && stats->struct_size < kFirstSize<fbrdf_draw_stats>)
            throw Failure(
                FBRDF_RESULT_ERROR_VERSION,
                "stats: " +
                    fbrdf::Found("a size of " + std::to_string(stats->struct_size) + " bytes")
                        .expected("at least " + std::to_string(kFirstSize<fbrdf_draw_stats>)));
        const fbrdf::gl::View view{glm::make_mat4(known.view), glm::make_mat4(known.projection),
                                   depthOf(known.depth)};
        const auto result = act(shared.renderer, targetOf(known), view, known);
        if (stats) report(result, stats);
    });
}

}  // namespace

fbrdf_result fbrdf_draw(fbrdf_renderer* renderer, const fbrdf_draw_desc* desc,
                        fbrdf_draw_stats* stats)
{
    return drawn(renderer, desc, stats,
                 [](auto& gl, const auto& target, const auto& view, const auto& known) {
                     return gl.draw(target, view, itemsOf(known), lightsOf(known),
                                    optionsOf(known));
                 });
}

fbrdf_result fbrdf_prepare(fbrdf_renderer* renderer, const fbrdf_draw_desc* desc)
{
    return guarded(logOf(renderer), [&] {
        Shared& shared = *required(renderer, "renderer").shared;
        const fbrdf_draw_desc known = descriptor(desc, "draw");
        const fbrdf::gl::DrawOptions options = optionsOf(known);
        const int lights = countOf(known.light_count, 0, "light_count");
        for (const fbrdf::gl::Item& item : itemsOf(known)) {
            required(item.material, "material of an item");
            required(item.mesh, "mesh of an item");
            shared.renderer.prepare(item, options, lights);
        }
    });
}

fbrdf_result fbrdf_draw_batch(fbrdf_renderer* renderer, const fbrdf_draw_desc* draw,
                              const fbrdf_batch_desc* batch, fbrdf_draw_stats* stats)
{
    return drawn(renderer, draw, stats,
                 [batch](auto& gl, const auto& target, const auto& view, const auto& known) {
                     if (known.item_count != 0)
                         throw Failure(FBRDF_RESULT_ERROR_ARGUMENT,
                                       "items: " + fbrdf::Found(std::to_string(known.item_count))
                                                       .expected("none with a batch"));
                     return gl.drawBatch(target, view, batchOf(descriptor(batch, "batch")),
                                         lightsOf(known), optionsOf(known));
                 });
}
