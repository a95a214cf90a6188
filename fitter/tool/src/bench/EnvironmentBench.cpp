#include "bench/EnvironmentBench.h"

#include "Output.h"
#include "Reflectance.h"
#include "TextTable.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/codecs/PanoramaFile.h>
#include <fbrdf/environment/LobeFit.h>
#include <fbrdf/peers/SplitSum.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <numeric>

namespace fbrdf::tool {
namespace {

constexpr char kSplitSum[] = "split sum";
constexpr int kDirections = 64;  // drawn by the lobes of the default fit

size_t bytesOf(const LobeTable& table)
{
    const auto lobes = static_cast<size_t>(table.lobes);
    const size_t numbers = table.axes == LobeAxes::bent ? 4 + 3 * lobes : 3 + 5 * lobes;
    return 2 * numbers * table.knots.size();
}

/// The directional albedo that the weights of a table add up to, at each pixel.
std::vector<Vec3d> albedos(const LobeTable& table, const EnvironmentSphere& sphere)
{
    std::vector<Vec3d> result;
    for (const EnvironmentSphere::Pixel& pixel : sphere.pixels()) {
        Vec3d sum(0.0);
        if (pixel.isSeen()) {
            const LobeSum<double> lobes = lobesAt(table, pixel.wo);
            sum = lobes.cosine;
            for (size_t k = 0; k < static_cast<size_t>(lobes.lobes); ++k) sum += lobes.weight[k];
        }
        result.push_back(sum);
    }
    return result;
}

std::vector<double> psnrs(const EnvironmentSphere& sphere,
                          const std::vector<EnvironmentSphere::Image>& images,
                          const std::vector<EnvironmentSphere::Image>& truth)
{
    std::vector<double> result;
    for (size_t e = 0; e < images.size(); ++e)
        result.push_back(sphere.psnr(images[e], truth[e], e));
    return result;
}

EnvironmentScores scoreSource(const std::string& name, const EnvironmentSphere& sphere,
                              const SplitSum& splitSum, const EnvironmentBenchOptions& options)
{
    const Source source = openSource(name, options.source);
    if (!source.evaluate)
        throw Error(ErrorKind::input, name,
                    Found("scattered samples").expected("a material, a model or a function"));
    EnvironmentScores result{name, {}, {}};
    const auto truth = sphere.truth(source.evaluate);
    const bool isotropic = isIsotropic(source.evaluate);
    std::vector<EnvironmentScore> ours;
    LobeTable table, drawnBy;
    EnvironmentScore directions;
    for (const int lobes : options.lobes) {
        LobeFitOptions fit = lobeOptions(lobes);
        fit.threads = options.threads;
        const auto start = std::chrono::steady_clock::now();
        table = fitLobes(source.evaluate, isotropic, fit);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        ours.push_back(
            {isotropic ? fmt::format("K = {}", lobes) : fmt::format("{} normals", fit.normals),
             psnrs(sphere, sphere.lit(table), truth), bytesOf(table), seconds.count()});
        if (lobes > LobeFitOptions().lobes) continue;
        drawnBy = table;
        directions = ours.back();
    }
    directions.label = fmt::format("{} directions", kDirections);
    directions.psnr = psnrs(sphere, sphere.sampled(drawnBy, source.evaluate, kDirections), truth);
    ours.push_back(directions);
    const SplitSum::Fit best = splitSum.best(truth, albedos(table, sphere));
    result.scores.push_back({kSplitSum, best.psnr, 0, 0.0});
    result.scores.insert(result.scores.end(), ours.begin(), ours.end());
    return result;
}

std::string scoreText(const EnvironmentScore& score)
{
    return fmt::format("{:.1f} {:.1f}", score.mean(), score.worst());
}

/// The scores of one way of drawing on all materials that have it.
std::vector<EnvironmentScore> allOf(const std::vector<EnvironmentScores>& materials, size_t way)
{
    std::vector<EnvironmentScore> result;
    for (const EnvironmentScores& material : materials)
        if (way < material.scores.size()) result.push_back(material.scores[way]);
    return result;
}

EnvironmentScore together(const std::vector<EnvironmentScore>& scores)
{
    EnvironmentScore result;
    for (const EnvironmentScore& score : scores)
        result.psnr.insert(result.psnr.end(), score.psnr.begin(), score.psnr.end());
    return result;
}

/// The smallest lead over the split sum of the means of a material.
double smallestLead(const std::vector<EnvironmentScores>& materials, size_t way)
{
    double least = 1e9;
    for (const EnvironmentScores& material : materials)
        if (way < material.scores.size())
            least = std::min(least, material.scores[way].mean() - material.scores[0].mean());
    return least;
}

}  // namespace

double EnvironmentScore::mean() const
{
    return std::accumulate(psnr.begin(), psnr.end(), 0.0) / static_cast<double>(psnr.size());
}

double EnvironmentScore::worst() const
{
    return *std::min_element(psnr.begin(), psnr.end());
}

std::vector<NamedPanorama> environmentsOf(const std::string& folder)
{
    namespace fs = std::filesystem;
    std::vector<fs::path> paths;
    std::error_code failed;
    for (const auto& entry : fs::directory_iterator(folder, failed)) {
        const std::string extension = entry.path().extension().string();
        if (extension == ".exr" || extension == ".hdr") paths.push_back(entry.path());
    }
    if (paths.empty())
        throw Error(ErrorKind::input, folder,
                    Found(failed ? "no such folder" : "no environment")
                        .expected("a folder of .exr or .hdr files"));
    std::sort(paths.begin(), paths.end());
    std::vector<NamedPanorama> environments;
    for (const fs::path& path : paths) {
        NamedPanorama& environment = environments.emplace_back();
        environment.name = path.stem().string();
        environment.panorama = readPanorama(path.string(), &environment.note);
    }
    return environments;
}

std::vector<EnvironmentScores> scoreEnvironments(const std::vector<std::string>& sources,
                                                 const std::vector<NamedPanorama>& environments,
                                                 const EnvironmentBenchOptions& options,
                                                 Progress& progress)
{
    progress.phase("filtering environments");
    std::vector<Panorama> panoramas;
    for (const NamedPanorama& environment : environments) panoramas.push_back(environment.panorama);
    const EnvironmentSphere sphere(panoramas, options.size,
                                   EnvironmentSphere::cubeSizeFor(options.size), options.threads);
    const SplitSum splitSum(sphere, options.threads);
    std::vector<EnvironmentScores> result;
    for (const std::string& source : sources) {
        progress.phase("lighting " + source);
        try {
            result.push_back(scoreSource(source, sphere, splitSum, options));
        } catch (const Error& error) {
            // A material that cannot be read must not lose the results of the others.
            result.push_back({source, {}, oneLine(error.what())});
        }
    }
    return result;
}

std::string environmentText(const std::vector<EnvironmentScores>& materials,
                            const std::vector<NamedPanorama>& environments)
{
    std::string text = "PSNR over the sphere, dB: mean and worst of ";
    for (const NamedPanorama& environment : environments)
        text += (&environment == &environments.front() ? "" : ", ") + environment.name;
    size_t ways = 0;
    for (const EnvironmentScores& material : materials)
        ways = std::max(ways, material.scores.size());
    std::vector<std::vector<std::string>> rows{{"material"}};
    std::vector<Align> aligned{Align::left};
    for (size_t way = 0; way < ways; ++way) {
        rows[0].push_back(allOf(materials, way).front().label);
        aligned.push_back(Align::right);
    }
    for (const EnvironmentScores& material : materials) {
        rows.push_back({material.source});
        for (const EnvironmentScore& score : material.scores)
            rows.back().push_back(scoreText(score));
        if (!material.error.empty()) rows.back().push_back(material.error);
        rows.back().resize(ways + 1);
    }
    const auto summary = [&](const char* name, const auto& value) {
        rows.push_back({name});
        for (size_t way = 0; way < ways; ++way) rows.back().push_back(value(way));
    };
    summary("all", [&](size_t way) { return scoreText(together(allOf(materials, way))); });
    summary("smallest lead over the split sum", [&](size_t way) {
        return way == 0 ? std::string() : fmt::format("{:.1f}", smallestLead(materials, way));
    });
    summary("bytes", [&](size_t way) {
        return way == 0 ? std::string() : fmt::format("{}", allOf(materials, way).front().bytes);
    });
    summary("seconds a fit", [&](size_t way) {
        double sum = 0.0;
        const auto scores = allOf(materials, way);
        for (const EnvironmentScore& score : scores) sum += score.seconds;
        return way == 0 ? std::string()
                        : fmt::format("{:.2f}", sum / static_cast<double>(scores.size()));
    });
    text += "\n" + alignedTable(aligned, rows, 2);
    for (const NamedPanorama& environment : environments)
        if (!environment.note.empty()) text += environment.name + ": " + environment.note + "\n";
    return text;
}

Json environmentJson(const std::vector<EnvironmentScores>& materials,
                     const std::vector<NamedPanorama>& environments)
{
    Json json = {{"environments", Json::array()}, {"materials", Json::array()}};
    for (const NamedPanorama& environment : environments) {
        json["environments"].push_back(environment.name);
        if (!environment.note.empty()) json["notes"][environment.name] = environment.note;
    }
    for (const EnvironmentScores& material : materials) {
        Json entry = {{"source", material.source}, {"ways", Json::array()}};
        if (!material.error.empty()) entry["error"] = material.error;
        for (const EnvironmentScore& score : material.scores)
            entry["ways"].push_back({{"name", score.label},
                                     {"psnr", score.psnr},
                                     {"mean", score.mean()},
                                     {"worst", score.worst()},
                                     {"bytes", score.bytes},
                                     {"seconds", score.seconds}});
        json["materials"].push_back(entry);
    }
    return json;
}

}  // namespace fbrdf::tool
