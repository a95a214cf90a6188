#include "Tables.h"

#include "Html.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace fbrdf {
namespace {

// A cell of text or of a number; numbers are aligned right.
std::string cell(const std::string& content, const char* cssClass = nullptr)
{
    return element("td", cssClass ? fmt::format("class=\"{}\"", cssClass) : "", content);
}

std::string numberCell(const std::string& content)
{
    return cell(content, "num");
}

std::string heading(const std::string& content, const char* attributes = "scope=\"col\"")
{
    return element("th", attributes, content);
}

std::string rowHeading(const std::string& content)
{
    return heading(content, "scope=\"row\"");
}

std::string row(const std::string& cells, const std::string& attributes = "")
{
    return element("tr", attributes, cells) + "\n";
}

// The class "whole" is for tables that are short enough to stay on one printed page.
std::string table(const char* cssClass, const std::string& caption, const std::string& head,
                  const std::string& body)
{
    return fmt::format("<table class=\"{}\">", cssClass) + element("caption", "", caption) +
           element("thead", "", row(head)) + element("tbody", "", body) + "</table>\n";
}

// How the names of Metrics.h are written for people.
struct MetricText {
    const char *name, *label, *meaning;
};
constexpr MetricText kSampleMetrics[] = {
    {"log_median", "log median", "median of |ln g/f| above the noise floor, averaged over R, G, B"},
    {"log_median_r", "log median, R", "the same, red alone"},
    {"log_median_g", "log median, G", "green alone"},
    {"log_median_b", "log median, B", "blue alone"},
    {"log_rms", "log RMS", "root mean square of ln g/f above the noise floor"},
    {"cos_rms", "cosine RMS",
     "RMS of cos \xCE\xB8<sub>i</sub> (g \xE2\x88\x92 f), relative to that of cos "
     "\xCE\xB8<sub>i</sub> f"},
    {"cuberoot_rms", "cube-root RMS",
     "the same of (cos \xCE\xB8<sub>i</sub> f)<sup>1/3</sup>: closer to what is seen"},
    {"nbrdf_loss", "NBRDF loss",
     "mean difference of ln(1 + cos \xCE\xB8<sub>i</sub> f), Sztrajman et al. 2021"},
};
constexpr MetricText kImageMetrics[] = {
    {"psnr_linear", "PSNR, linear (dB)",
     "standard sphere, linear radiance, peak 1; higher is better"},
    {"psnr_srgb", "PSNR, sRGB (dB)", "the same of sRGB-encoded values"},
    {"ssim", "SSIM", "structural similarity of luma, Wang et al. 2004; 1 is equal"},
    {"delta_e_itp",
     "\xCE\x94"
     "E ITP",
     "mean colour difference, ITU-R BT.2124; 1 is just noticeable"},
    {"flip", "FLIP", "mean, Andersson et al. 2020, 67 pixels a degree; 0 is equal"},
};
constexpr MetricText kPhysicsMetrics[] = {
    {"reciprocity", "reciprocity", "median |ln f(a, b)/f(b, a)|; 0 is reciprocal"},
    {"albedo_max", "largest albedo",
     "directional albedo, 16 incidences to 85\xC2\xB0; above 1 makes light"},
};

std::string metricLabel(const std::string& name)
{
    for (const MetricText& m : kSampleMetrics)
        if (name == m.name) return m.label;
    for (const MetricText& m : kImageMetrics)
        if (name == m.name) return m.label;
    return escaped(name);
}

std::string captionText(const std::string& heldOutNote)
{
    return heldOutNote.empty()
               ? "g is the fit as stored, f the data."
               : "g is the fit as stored, f the data. Held out: " + escaped(heldOutNote) + ".";
}

std::string formText(const ReportTrial& trial)
{
    const std::string name = element("b", "", escaped(trial.form));
    const std::string mark = trial.chosen ? " <span class=\"chosen\">chosen</span>" : "";
    const std::string stage = trial.stage.empty() ? "" : " (" + escaped(trial.stage) + ")";
    return name + stage + mark + element("div", "class=\"detail\"", escaped(trial.description));
}

// Columns of the table of forms: the errors that any trial has, those of Metrics.h first and in its
// order. Errors of single channels are left out, because more columns do not fit a page.
std::vector<std::string> errorColumns(const std::vector<ReportTrial>& trials)
{
    std::set<std::string> present;
    for (const ReportTrial& trial : trials)
        for (const auto& entry : trial.errors) present.insert(entry.first);
    std::vector<std::string> columns;
    for (const MetricText& m : kSampleMetrics) {
        const std::string name = m.name;
        const bool isChannel = name.rfind("log_median_", 0) == 0;
        if (present.erase(name) > 0 && !isChannel) columns.push_back(name);
    }
    columns.insert(columns.end(), present.begin(), present.end());
    return columns;
}

std::string countRow(const char* label, uint64_t count, const char* meaning)
{
    return row(rowHeading(label) + numberCell(grouped(count)) + cell(meaning, "detail"));
}

std::string vectorText(const Vec3f& v)
{
    const auto one = [&](int c) { return shortNumber(static_cast<double>(v[c])); };
    return one(0) + " / " + one(1) + " / " + one(2);
}

}  // namespace

std::string metricsTable(const ReportInput& input, const ImageErrors* image)
{
    const auto heldOut = named(input.heldOut), all = named(input.all);
    std::string body;
    for (const MetricText& m : kSampleMetrics)
        body += row(rowHeading(m.label) + numberCell(number(heldOut.at(m.name))) +
                    numberCell(number(all.at(m.name))) + cell(m.meaning, "detail"));
    const auto spanning = [&](const MetricText& m, double value) {
        return row(rowHeading(m.label) +
                   element("td", "class=\"num\" colspan=\"2\"", number(value)) +
                   cell(m.meaning, "detail"));
    };
    if (image)
        for (const MetricText& m : kImageMetrics) body += spanning(m, named(*image).at(m.name));
    for (const MetricText& m : kPhysicsMetrics)
        body += spanning(m, named(input.physics).at(m.name));
    return table("whole", captionText(input.heldOutNote),
                 heading("Metric") + heading("held out", "scope=\"col\" class=\"num\"") +
                     heading("all samples", "scope=\"col\" class=\"num\"") +
                     heading("what it is", "scope=\"col\" class=\"detail\""),
                 body);
}

std::string trialsTable(const std::vector<ReportTrial>& trials)
{
    constexpr const char* kNum = "scope=\"col\" class=\"num\"";
    const std::vector<std::string> names = errorColumns(trials);
    std::string head = heading("Form") + heading("bytes", kNum) + heading("look-ups", kNum) +
                       heading("seconds", kNum);
    for (const std::string& name : names) head += heading(metricLabel(name), kNum);
    std::string body;
    for (const ReportTrial& trial : trials) {
        std::string cells =
            element("th", "scope=\"row\"", formText(trial)) + numberCell(grouped(trial.bytes)) +
            numberCell(std::to_string(trial.lookups)) + numberCell(shortNumber(trial.seconds));
        for (const std::string& name : names) {
            const auto found = trial.errors.find(name);
            cells += numberCell(found == trial.errors.end() ? "" : number(found->second));
        }
        body += row(cells, trial.chosen ? "class=\"is-chosen\"" : "");
    }
    return table("long", "Errors are on held-out samples. Look-ups are texture look-ups per light.",
                 head, body);
}

std::string samplesTable(const ReportInput& input)
{
    const SampleReport found = input.rows.value_or(input.source.report);
    std::string body =
        countRow("used", input.counts.used, "samples that took part in the fit") +
        countRow("invalid", input.counts.invalid, "samples that could not take part") +
        countRow("below the floor", input.counts.belowFloor,
                 "channel values at or below the noise floor: censored, not equal to it");
    if (found.given > 0)
        body += countRow("rows in the file", found.given, "usable or not") +
                countRow("not finite", found.nonFinite, "a value or an angle that is no number") +
                countRow("below the horizon", found.belowHorizon,
                         "light or view at or under the surface") +
                countRow("marked invalid", found.invalid, "marked by the file as not measured") +
                countRow("negative", found.negative, "kept: a channel below 0") +
                countRow("zero", found.zero, "kept: a channel that is exactly 0") +
                countRow("out of gamut", found.outOfGamut, "spectra outside the sRGB primaries");
    body += row(rowHeading("noise floor") +
                element("td", "class=\"num\"", vectorText(input.noiseFloor)) +
                cell("1/sr, for R / G / B", "detail"));
    return table("whole", "What became of the rows of the data.",
                 heading("Samples") + heading("number", "scope=\"col\" class=\"num\"") +
                     heading("what they are", "scope=\"col\" class=\"detail\""),
                 body);
}

std::string materialTable(const Material& material)
{
    std::string body = row(rowHeading("form") + cell(escaped(material.form.name))) +
                       row(rowHeading("product") + cell(escaped(describe(material.form)), "wrap")) +
                       row(rowHeading("bytes") + cell(grouped(materialBytes(material))));
    for (size_t i = 0; i < material.scales.size(); ++i)
        body += row(rowHeading(material.scales.size() > 1 ? fmt::format("scale of term {}", i + 1)
                                                          : "scale") +
                    cell(vectorText(material.scales[i])));
    for (const auto& [key, value] : material.notes)
        body += row(rowHeading(escaped(key)) + cell(escaped(value), "wrap"));
    return table("whole", "What the material file contains.", heading("Item") + heading("value"),
                 body);
}

}  // namespace fbrdf
