#include "bench/AreaBench.h"

#include "Output.h"
#include "Reflectance.h"
#include "TextTable.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/environment/LobeFit.h>
#include <fmt/format.h>

#include <algorithm>

namespace fbrdf::tool {
namespace {

using Errors = AreaSphere::Errors;

AreaScores areaScoresOf(const std::string& name, const AreaSphere& sphere,
                        const AreaBenchOptions& options)
{
    const Source source = openSource(name, options.source);
    if (!source.evaluate)
        throw Error(ErrorKind::input, name,
                    Found("scattered samples").expected("a material, a model or a function"));
    AreaScores result{name, {}, {}};
    const auto truth = sphere.truth(source.evaluate);
    const bool isotropic = isIsotropic(source.evaluate);
    for (const int lobes : options.lobes) {
        LobeFitOptions fit = lobeOptions(lobes);
        fit.threads = options.threads;
        const auto lit = sphere.lit(fitLobes(source.evaluate, isotropic, fit));
        AreaScore& score = result.scores.emplace_back();
        score.label =
            isotropic ? fmt::format("K = {}", lobes) : fmt::format("{} normals", fit.normals);
        for (size_t light = 0; light < lit.size(); ++light)
            score.errors.push_back(sphere.errors(lit[light], truth[light], light));
    }
    return result;
}

/// Errors of one way of drawing under the lights of one shape.
std::vector<Errors> errorsOf(const AreaScore& score, AreaLight::Shape shape)
{
    const auto lights = comparedAreaLights();
    std::vector<Errors> errors;
    for (size_t i = 0; i < lights.size(); ++i)
        if (lights[i].light.shape == shape) errors.push_back(score.errors[i]);
    return errors;
}

/// Mean and worst of one kind of error.
struct Spread {
    double sum = 0.0, worst = 0.0;
    void add(double value)
    {
        sum += value;
        worst = std::max(worst, value);
    }
};

std::string errorText(const std::vector<Errors>& errors)
{
    double psnrs = 0.0, leastPsnr = errors.front().psnr;
    Spread reflected, rms, largest;
    for (const Errors& e : errors) {
        psnrs += e.psnr;
        leastPsnr = std::min(leastPsnr, e.psnr);
        reflected.add(100.0 * e.reflected);
        rms.add(100.0 * e.rms);
        largest.add(100.0 * e.largest);
    }
    const auto count = static_cast<double>(errors.size());
    return fmt::format("{:.1f} {:.1f}  {:.1f} {:.1f}  {:.1f} {:.1f}  {:.0f} {:.0f}", psnrs / count,
                       leastPsnr, reflected.sum / count, reflected.worst, rms.sum / count,
                       rms.worst, largest.sum / count, largest.worst);
}

}  // namespace

std::vector<AreaScores> scoreAreaLights(const std::vector<std::string>& sources,
                                        const AreaBenchOptions& options, Progress& progress)
{
    const AreaSphere sphere(comparedAreaLights(), options.size, options.threads);
    std::vector<AreaScores> result;
    for (const std::string& source : sources) {
        progress.phase("lighting " + source);
        try {
            result.push_back(areaScoresOf(source, sphere, options));
        } catch (const Error& error) {
            // A material that cannot be read must not lose the results of the others.
            result.push_back({source, {}, oneLine(error.what())});
        }
    }
    return result;
}

std::string areaText(const std::vector<AreaScores>& materials)
{
    std::string text =
        "PSNR over the sphere in dB, error of all reflected light in %, rms and largest difference "
        "in % of the peak: mean and worst of each\n";
    for (const auto shape : {AreaLight::Shape::sphere, AreaLight::Shape::rectangle}) {
        size_t ways = 0;
        for (const AreaScores& material : materials) ways = std::max(ways, material.scores.size());
        std::vector<std::vector<std::string>> rows{{std::string(shapeName(shape)) + "s"}};
        std::vector<std::vector<Errors>> all(ways);
        std::vector<Align> aligned{Align::left};
        for (size_t way = 0; way < ways; ++way) aligned.push_back(Align::right);
        for (const AreaScores& material : materials) {
            rows.push_back({material.source});
            for (size_t way = 0; way < material.scores.size(); ++way) {
                const auto errors = errorsOf(material.scores[way], shape);
                all[way].insert(all[way].end(), errors.begin(), errors.end());
                rows.back().push_back(errorText(errors));
                if (rows[0].size() <= way + 1) rows[0].push_back(material.scores[way].label);
            }
            if (!material.error.empty()) rows.back().push_back(material.error);
            rows.back().resize(ways + 1);
        }
        rows.push_back({"all"});
        for (const auto& errors : all) rows.back().push_back(errorText(errors));
        text += "\n" + alignedTable(aligned, rows, 2);
    }
    return text;
}

Json areaJson(const std::vector<AreaScores>& materials)
{
    const auto lights = comparedAreaLights();
    Json json = {{"materials", Json::array()}};
    for (const AreaScores& material : materials) {
        Json entry = {{"source", material.source}, {"ways", Json::array()}};
        if (!material.error.empty()) entry["error"] = material.error;
        for (const AreaScore& score : material.scores) {
            Json way = {{"name", score.label}, {"lights", Json::array()}};
            for (size_t i = 0; i < lights.size(); ++i)
                way["lights"].push_back({{"name", lights[i].name},
                                         {"psnr", score.errors[i].psnr},
                                         {"reflected", score.errors[i].reflected},
                                         {"rms", score.errors[i].rms},
                                         {"largest", score.errors[i].largest}});
            entry["ways"].push_back(way);
        }
        json["materials"].push_back(entry);
    }
    return json;
}

}  // namespace fbrdf::tool
