#include "CursorInspector.h"

#include <fbrdf/plan/Transfer.h>

#include <fmt/core.h>

#include <chrono>
#include <cmath>

namespace fbrdf::viewer {

CursorInspector::CursorInspector(gl::LoadFunction load) : gl_(loadGlFunctions(load)) {}

CursorInspector::~CursorInspector()
{
    for (const auto& [key, map] : maps_) gl_.DeleteTextures(1, &map.texture);
}

const CursorInspector::Map& CursorInspector::mapOf(size_t subject, const CursorSubject& asked,
                                                   int table, int slice)
{
    Map& map = maps_[{subject, table}];
    if (map.texture == 0) gl_.GenTextures(1, &map.texture);
    if (map.material == asked.material && map.revision == asked.revision && map.slice == slice)
        return map;
    const scene::Image picture =
        mapPicture(asked.material->tables[static_cast<size_t>(table)], slice);
    const std::vector<uint8_t> codes = srgbCodes(picture, 1.0f, Transfer::srgb);
    gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl_.BindTexture(GL_TEXTURE_2D, map.texture);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, picture.width, picture.height, 0, GL_RGB,
                   GL_UNSIGNED_BYTE, codes.data());
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    gl_.BindTexture(GL_TEXTURE_2D, 0);
    gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    map.width = picture.width;
    map.height = picture.height;
    map.material = asked.material;
    map.revision = asked.revision;
    map.slice = slice;
    return map;
}

void CursorInspector::answerFor(size_t subject, const CursorSubject& asked,
                                const DirectionPair<double>& pair)
{
    CursorFacts::Subject& facts = facts_.subjects[subject];
    facts.title = asked.title;
    facts.material = asked.material;
    facts.maps.clear();
    facts.curve = polarCurve(asked.brdf, pair.wi);
    facts.f = pair.wo.z > 0.0 && pair.wi.z > 0.0 ? asked.brdf(pair.wo, pair.wi) : Vec3d(0.0);
    if (!asked.material) return;
    for (const TexelRead& read : texelsRead(*asked.material, pair)) {
        const auto slice = static_cast<int>(std::lround(read.position.z));
        const Map& map = mapOf(subject, asked, read.table, slice);
        facts.maps.push_back({read.name, map.texture, map.width, map.height, read.position,
                              read.texels, read.value});
    }
}

/// Reads the samples of a new source on a thread; until they are there, there are none.
void CursorInspector::findSamples(const std::shared_ptr<const Source>& source, const Vec3d& wi)
{
    facts_.samples.clear();
    if (!source || !hasSamples(*source)) {
        facts_.samplesNote = source ? "the source is a function: no samples"
                                    : "a material file: its samples are not known";
        return;
    }
    const bool isThere =
        reading_.valid() && reading_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    if (isThere) samples_ = reading_.get();
    if (source_ != source && !reading_.valid()) {
        source_ = source;
        samples_.reset();
        reading_ = std::async(std::launch::async,
                              [source] { return std::make_shared<const PlaneSamples>(*source); });
    }
    if (!samples_ || source_ != source) {
        facts_.samplesNote = "reading samples ...";
        return;
    }
    facts_.samples = samples_->near(wi, kPlaneTolerance);
    facts_.samplesNote = fmt::format("{} of {} samples within {:g} degrees", facts_.samples.size(),
                                     samples_->size(), kPlaneTolerance);
}

void CursorInspector::answer(const CursorQuestion& question)
{
    facts_.place = question.place;
    const auto hit = hitAt(question.instances, question.view, question.place);
    facts_.hits = hit.has_value();
    if (!hit) return;
    facts_.light = strongestLight(*hit, *question.lights);
    const DirectionPair<double> pair{hit->wo, facts_.light.wi};
    facts_.angles = anglesOf(pair);
    for (size_t i = 0; i < 2; ++i) answerFor(i, question.subjects[i], pair);
    findSamples(question.source, pair.wi);
    facts_.most = mostOf({facts_.subjects[0].curve, facts_.subjects[1].curve, facts_.samples});
}

}  // namespace fbrdf::viewer
