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

/// Compares f, as pictures, with its means with other functions.
class MeanErrors {
public:
    MeanErrors(const BrdfFunction& brdf, int threads) : brdf_(brdf), threads_(threads) {}

    /// PSNR in dB.
    double psnrWith(const BrdfFunction& partner)
    {
        if (whole_.size == 0) whole_ = pictureOf(brdf_);
        return imageErrors(pictureOf([&](const Vec3d& wo, const Vec3d& wi) {
                               return 0.5 * (brdf_(wo, wi) + partner(wo, wi));
                           }),
                           whole_)
            .psnrLinear;
    }

private:
    SphereImage pictureOf(const BrdfFunction& brdf) const
    {
        return renderStandardSphere(brdf, 256, threads_);
    }

    const BrdfFunction& brdf_;
    int threads_;
    SphereImage whole_;
};

void measureFunction(const Source& source, int threads, DataInfo& info)
{
    constexpr double kSymmetric = 1e-3;  // below what any material of ours resolves
    // Networks, which are slow, differ by less from their mirror images for want of training.
    constexpr double kOneSided = 0.02;
    const BrdfFunction& f = source.evaluate;
    MeanErrors means(f, threads);
    info.reciprocity = medianReciprocityError(f, threads);
    info.reciprocityNote = "over the uniform set";
    if (*info.reciprocity > kSymmetric)
        info.reciprocalPsnr =
            means.psnrWith([&f](const Vec3d& wo, const Vec3d& wi) { return f(wi, wo); });
    info.albedo = albedoTable(f, threads);
    if (!source.isotropic) return;
    info.mirror = medianMirrorError(f, threads);
    if (*info.mirror > kOneSided)
        info.mirrorPsnr = means.psnrWith(
            [&f](const Vec3d& wo, const Vec3d& wi) { return f(mirrored(wo), mirrored(wi)); });
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

std::string mirrorText(const DataInfo& info)
{
    const std::string text =
        fmt::format("{:.3g}  (median |ln f / f mirrored at the plane of incidence|)", *info.mirror);
    return info.mirrorPsnr ? text + fmt::format("; its mirrored mean: {:.1f} dB", *info.mirrorPsnr)
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
    json["mirror"] = info.mirror ? jsonOf(*info.mirror) : Json();
    json["mirror_psnr"] = info.mirrorPsnr ? jsonOf(*info.mirrorPsnr) : Json();
    if (info.function) json["directional_albedo"] = jsonOf(info.albedo);
    return json;
}

std::string textOf(const DataInfo& info)
{
    std::vector<std::vector<std::string>> rows{
        {"format", info.format},
        {"contains", info.description},
        {"values", info.function ? "for any pair" : "at samples only"},
        {"isotropic", info.isotropic ? "yes" : "not known to be"},
        {"reciprocity", reciprocityText(info)}};
    if (info.mirror) rows.push_back({"mirror image", mirrorText(info)});
    std::string text = info.name + "\n" + alignedTable({Align::left, Align::left}, rows);
    if (!info.assumptions.empty()) text += assumptionsText(info.assumptions);
    if (info.sampled) text += samplesText(info);
    if (info.function) text += textOf(info.albedo);
    return text;
}

}  // namespace fbrdf::tool
