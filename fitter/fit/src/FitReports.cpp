// FitReports.cpp - the summary of a fit as text for people.
#include <fbrdf/fit/Fit.h>
#include <fmt/format.h>

#include <cmath>

namespace fbrdf {
namespace {

std::string number(double value)
{
    return fmt::format("{:.3g}", value);
}

std::string line(const std::string& name, const std::string& value)
{
    return name + std::string(name.size() < 14 ? 14 - name.size() : 1, ' ') + value + "\n";
}

std::string colour(const Vec3f& value)
{
    return number(static_cast<double>(value.x)) + " " + number(static_cast<double>(value.y)) + " " +
           number(static_cast<double>(value.z));
}

std::string errorsText(const SampleErrors& e)
{
    return "log_median " + number(e.logMedian) + ", log_rms " + number(e.logRms) + ", cos_rms " +
           number(e.cosRms) + ", cuberoot_rms " + number(e.cubeRootRms) + ", nbrdf_loss " +
           number(e.nbrdfLoss);
}

// The name of the samples that the held-out errors come from.
std::string heldOutName(int folds)
{
    return folds > 0 ? "held out (" + std::to_string(folds) + ")" : "fresh pairs";
}

std::string samplesText(const FitSummary& summary)
{
    return std::to_string(summary.used) + " used, " + std::to_string(summary.belowFloor) +
           " values below the noise floor " + colour(summary.noiseFloor);
}

std::string secondsText(const FitSummary& summary)
{
    return number(summary.readSeconds) + " to read, " + number(summary.seconds) + " to fit, " +
           number(summary.processorSeconds) + " of processor time";
}

std::string triedForms(const std::vector<Trial>& trials)
{
    std::string text;
    for (const Trial& trial : trials)
        text += line(trial.chosen ? "  * " + trial.stage : "    " + trial.stage,
                     trial.form + ", " + std::to_string(trial.bytes) + " bytes, score " +
                         number(trial.score) + ": " + trial.description);
    return text.empty() ? text : "forms tried, * the one chosen\n" + text;
}

}  // namespace

std::string FitSummary::briefReport() const
{
    return solver.text() + "; log_median " + number(heldOut.logMedian) + " on " +
           heldOutName(folds) + ", " + number(all.logMedian) + " on all samples";
}

std::string describe(const Tilt& tilt)
{
    constexpr double kDegrees = 180.0 / kPi;
    return fmt::format("surface {:.2f} degrees off its holder, towards azimuth {:.0f}: turned back",
                       std::hypot(tilt.x, tilt.y) * kDegrees,
                       std::atan2(tilt.y, tilt.x) * kDegrees);
}

std::string FitSummary::fullReport() const
{
    std::string text = line("solver", solver.text()) + line("smoothness", number(smoothness)) +
                       line("samples", samplesText(*this)) + line("seconds", secondsText(*this)) +
                       line(heldOutName(folds), errorsText(heldOut)) + line("all", errorsText(all));
    if (conserved != 1.0) text += line("energy", "scaled by " + number(conserved));
    if (tilt) text += line("tilt", describe(*tilt));
    if (coverage) text += line("coverage", describe(*coverage));
    for (const MisfitRegion& region : misfits) text += line("misfit", describe(region));
    if (!reason.empty()) text += line("form", reason);
    return text + triedForms(trials);
}

}  // namespace fbrdf
