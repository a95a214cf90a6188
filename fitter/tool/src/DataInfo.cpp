#include "DataInfo.h"

#include "FitJob.h"
#include "SampleFacts.h"
#include "TextTable.h"

#include <fbrdf/fit/NoiseFloor.h>
#include <fbrdf/metrics/StandardSphere.h>
#include <fmt/format.h>

#include <algorithm>

namespace fbrdf::tool {
namespace {

void measureSamples(const Source& source, DataInfo& info)
{
    const SampleSurvey survey = surveyOf(source);
    const std::vector<Sample>& samples = survey.thinned;
    info.report = survey.report;
    info.usable = survey.usable;
    info.least = survey.least;
    info.most = survey.most;
    info.floor = estimateNoiseFloor(samples);
    if (info.function) return;
    const SampleReciprocity found = sampleReciprocity(samples, source.isotropic, info.floor);
    if (found.pairs > 0) {
        info.reciprocity = found.median;
        info.reciprocityNote =
            fmt::format("over {} of {} samples, those measured both ways within 2 degrees",
                        withSeparators(found.pairs), withSeparators(found.lookedUp));
    } else {
        info.reciprocityNote = "no pair was measured both ways";
    }
}

double psnrOfReciprocalMean(const BrdfFunction& brdf, int threads)
{
    const auto mean = [&brdf](const Vec3d& wo, const Vec3d& wi) {
        return 0.5 * (brdf(wo, wi) + brdf(wi, wo));
    };
    return imageErrors(renderStandardSphere(mean, 256, threads),
                       renderStandardSphere(brdf, 256, threads))
        .psnrLinear;
}

void measureFunction(const Source& source, int threads, DataInfo& info)
{
    constexpr double kReciprocal = 1e-3;  // below what any material of ours resolves
    info.reciprocity = medianReciprocityError(source.evaluate, threads);
    info.reciprocityNote = "over the uniform set";
    if (*info.reciprocity > kReciprocal)
        info.reciprocalPsnr = psnrOfReciprocalMean(source.evaluate, threads);
    info.albedo = albedoTable(source.evaluate, threads);
}

std::string colourText(const Vec3f& v)
{
    return fmt::format("{:.4g} {:.4g} {:.4g}", v.x, v.y, v.z);
}

Json samplesJson(const DataInfo& info)
{
    const SampleReport& report = info.report;
    return {{"given", report.given},
            {"usable", info.usable},
            {"invalid", invalidSamples(report)},
            {"non_finite", report.nonFinite},
            {"below_horizon", report.belowHorizon},
            {"marked_invalid", report.invalid},
            {"negative", report.negative},
            {"zero", report.zero},
            {"out_of_gamut", report.outOfGamut},
            {"noise_floor", jsonOf(info.floor)},
            {"least", jsonOf(info.least)},
            {"most", jsonOf(info.most)}};
}

std::string samplesText(const DataInfo& info)
{
    const SampleReport& report = info.report;
    return "  samples\n" +
           alignedTable({Align::left, Align::right, Align::left},
                        {{"given", withSeparators(report.given), ""},
                         {"usable", withSeparators(info.usable), ""},
                         {"not finite", withSeparators(report.nonFinite), "dropped"},
                         {"below horizon", withSeparators(report.belowHorizon), "dropped"},
                         {"marked invalid", withSeparators(report.invalid), "dropped"},
                         {"negative", withSeparators(report.negative), "censored by a fit"},
                         {"zero", withSeparators(report.zero), "censored by a fit"},
                         {"out of gamut", withSeparators(report.outOfGamut), ""}},
                        4) +
           alignedTable({Align::left, Align::left}, {{"noise floor", colourText(info.floor)},
                                                     {"least", colourText(info.least)},
                                                     {"most", colourText(info.most)}});
}

std::string reciprocityText(const DataInfo& info)
{
    if (!info.reciprocity) return "unknown: " + info.reciprocityNote;
    const std::string text = fmt::format("{:.3g}  (median |ln f(a, b) / f(b, a)| {})",
                                         *info.reciprocity, info.reciprocityNote);
    return info.reciprocalPsnr
               ? text + fmt::format("; its reciprocal mean: {:.1f} dB", *info.reciprocalPsnr)
               : text;
}

std::string assumptionsText(const std::vector<std::string>& assumptions)
{
    std::string text = "  assumed, as the file does not state it\n";
    for (const std::string& assumption : assumptions) text += "    " + assumption + "\n";
    return text;
}

}  // namespace

DataInfo dataInfo(const Source& source, int threads)
{
    DataInfo info;
    info.name = source.name;
    info.format = source.format;
    info.description = source.description;
    info.assumptions = source.assumptions;
    info.isotropic = source.isotropic;
    info.function = static_cast<bool>(source.evaluate);
    info.sampled = hasSamples(source);
    if (info.sampled) measureSamples(source, info);
    if (info.function) measureFunction(source, threads, info);
    return info;
}

Json jsonOf(const DataInfo& info)
{
    Json json{{"kind", "data"},
              {"name", info.name},
              {"format", info.format},
              {"description", info.description},
              {"assumptions", info.assumptions},
              {"units", "1/sr"},
              {"isotropic", info.isotropic},
              {"has_function", info.function}};
    if (info.sampled) json["samples"] = samplesJson(info);
    json["reciprocity"] = info.reciprocity ? jsonOf(*info.reciprocity) : Json();
    json["reciprocity_note"] = info.reciprocityNote;
    json["reciprocal_psnr"] = info.reciprocalPsnr ? jsonOf(*info.reciprocalPsnr) : Json();
    if (info.function) json["directional_albedo"] = jsonOf(info.albedo);
    return json;
}

std::string textOf(const DataInfo& info)
{
    std::string text = info.name + "\n" +
                       alignedTable({Align::left, Align::left},
                                    {{"format", info.format},
                                     {"contains", info.description},
                                     {"values", info.function ? "for any pair" : "at samples only"},
                                     {"isotropic", info.isotropic ? "yes" : "not known to be"},
                                     {"reciprocity", reciprocityText(info)}});
    if (!info.assumptions.empty()) text += assumptionsText(info.assumptions);
    if (info.sampled) text += samplesText(info);
    if (info.function) text += textOf(info.albedo);
    return text;
}

}  // namespace fbrdf::tool
