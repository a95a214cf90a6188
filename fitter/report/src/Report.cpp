#include <fbrdf/report/Report.h>

#include "ErrorFigures.h"
#include "Html.h"
#include "Invented.h"
#include "PolarFigures.h"
#include "SphereFigures.h"
#include "Style.h"
#include "TableFigures.h"
#include "Tables.h"

#include <fbrdf/base/OutputFile.h>
#include <fmt/format.h>

namespace fbrdf {
namespace {

std::string section(const std::string& title, const std::string& content)
{
    return content.empty()
               ? ""
               : element("section", "", element("h2", "", title) + "\n" + content) + "\n";
}

std::string paragraph(const std::string& content)
{
    return element("p", "", content);
}

std::string titleOf(const ReportInput& input)
{
    const std::string& name = input.material.name.empty() ? input.source.name : input.material.name;
    return escaped(name.empty() ? "material" : name);
}

// One figure of the summary at the top.
std::string fact(const std::string& value, const std::string& label)
{
    return element("div", "", element("dt", "", label) + element("dd", "", value));
}

std::string factsOf(const ReportInput& input, const std::optional<ImageErrors>& image)
{
    std::string facts = fact(escaped(input.material.form.name), "form") +
                        fact(grouped(materialBytes(input.material)), "bytes") +
                        fact(std::to_string(input.lookups), "look-ups per light") +
                        fact(shortNumber(input.seconds.fit) + " s", "to fit");
    facts += fact(number(input.heldOut.logMedian), "median |ln g/f|, held out");
    if (image)
        facts += fact(number(image->psnrLinear) + " dB", "PSNR, standard sphere") +
                 fact(number(image->deltaEItp),
                      "\xCE\x94"
                      "E ITP, mean");
    return element("dl", "class=\"facts\"", facts);
}

std::string headerOf(const ReportInput& input, const std::optional<ImageErrors>& image)
{
    std::string lead = escaped(input.source.description);
    if (!input.source.format.empty())
        lead += (lead.empty() ? "" : " ") + ("(" + escaped(input.source.format) + ")");
    std::string content = element("h1", "", titleOf(input));
    if (!lead.empty()) content += element("p", "class=\"lead\"", lead);
    content += factsOf(input, image);
    if (!input.command.empty()) content += element("pre", "", escaped(input.command));
    return element("header", "", content) + "\n";
}

// What a reader must know before any figure: the form fails, or half the directions are missing.
std::string warnings(const ReportInput& input)
{
    std::string text;
    if (!input.misfits.empty()) {
        std::string items;
        for (const MisfitRegion& region : input.misfits)
            items += element("li", "", escaped(describe(region)));
        text += element("p", "", element("b", "", "The form does not fit the data:")) +
                element("ul", "", items);
    }
    if (input.coverage && input.coverage->inPlane)
        text +=
            element("p", "", element("b", "", "Coverage: ") + escaped(describe(*input.coverage)));
    return text.empty() ? "" : element("section", "class=\"warning\"", text) + "\n";
}

// The share of all light from which on what is invented has a picture of its own. Fits to functions
// have texels without samples, too, that no picture shows.
constexpr double kLeastInvented = 0.001;

std::string spheresSection(const Material& material, const SphereImage& data,
                           const SphereImage& fit)
{
    const std::string scene =
        "Orthographic, under 6 directional lights and a sky of 122, exposed so that a Lambertian "
        "of albedo 0.5 averages 0.4.";
    const std::string note = data.size > 0
                                 ? scene
                                 : scene +
                                       " The data are samples without a function between them, "
                                       "so there is no picture of them.";
    std::optional<InventedSphere> invented;
    if (hasInvented(material)) invented = inventedSphere(material, fit.size);
    const bool isShown = invented && invented->total >= kLeastInvented;
    return section("Standard sphere",
                   paragraph(note) + sphereFigures(data, fit, isShown ? &*invented : nullptr));
}

std::string polarText(const std::vector<PolarPanel>& panels)
{
    const std::string scale =
        "Reflectance in the plane of incidence, without the cosine; the radius is logarithmic, in "
        "1/sr, the same in all plots.";
    if (panels.empty())
        return paragraph(fmt::format("No sample lies within {:g}\xC2\xB0 of a plane of incidence.",
                                     kPlaneTolerance));
    if (!panels.front().scattered) return paragraph(scale);
    return paragraph(
        scale +
        fmt::format(
            " Dots are samples within {:g}\xC2\xB0 of the plane and {:g}\xC2\xB0 of the incidence.",
            kPlaneTolerance, kIncidenceTolerance));
}

std::string polarSection(const ReportInput& input, const ComparisonSet& set)
{
    const auto panels = polarPanels(input.source, input.material, set);
    return section("Data against fit", polarText(panels) + polarFigures(panels));
}

std::string errorSection(const ReportInput& input, const ComparisonSet& set)
{
    if (set.samples.empty()) return "";
    const std::string whole =
        grouped(set.rows) + (set.measured ? " rows of the data" : " pairs of the uniform test set");
    const std::string over =
        set.samples.size() < set.rows ? grouped(set.samples.size()) + " of the " + whole : whole;
    const ErrorBins bins = errorBins(set, input.noiseFloor);
    return section("Where the error is",
                   paragraph("Over " + over +
                             ". The axis of \xCE\xB8<sub>h</sub> is divided by its square root; "
                             "hatched bins have no sample.") +
                       errorFigures(bins) + weakestPlaces(bins));
}

std::string mapsSection(const Material& material)
{
    const std::string note =
        "Disc maps show the hemisphere from above, the tangent to the right and its perpendicular "
        "down; rings are zenith "
        "angles. Grids start at the upper left. Of log maps, 1 % of the texels at either end may "
        "be beyond black or white.";
    return section("Maps", paragraph(note) + tableFigures(material));
}

std::string secondsText(const ReportSeconds& seconds)
{
    return paragraph(fmt::format("Seconds: read {}, fit {}, write {}.", number(seconds.read),
                                 number(seconds.fit), shortNumber(seconds.write)));
}

// The policy refuses everything that would be loaded from elsewhere, should it ever get in.
const char* const kPolicy =
    "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
    "style-src "
    "'unsafe-inline'\"/>";

std::string headOf(const ReportInput& input)
{
    return element("head", "",
                   std::string("<meta charset=\"utf-8\"/>") + kPolicy +
                       "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>"
                       "<meta name=\"color-scheme\" content=\"light dark\"/>" +
                       element("title", "", titleOf(input) + " &#8212; fit report") +
                       element("style", "", kStyle)) +
           "\n";
}

}  // namespace

std::string reportHtml(const ReportInput& input)
{
    const ComparisonSet set = comparisonSet(input.source, input.material);
    SphereImage data = input.sphereOfData, fit = input.sphereOfFit;
    const auto material = [&](const Vec3d& wo, const Vec3d& wi) {
        return evaluate<double>(input.material, wo, wi);
    };
    if (fit.size == 0) fit = renderStandardSphere(material);
    if (data.size == 0 && input.source.evaluate)
        data = renderStandardSphere(input.source.evaluate, fit.size);
    std::optional<ImageErrors> image = input.image;
    if (!image && data.size > 0) image = imageErrors(fit, data);

    const std::string body =
        headerOf(input, image) + warnings(input) + spheresSection(input.material, data, fit) +
        polarSection(input, set) + errorSection(input, set) + mapsSection(input.material) +
        section("Metrics", metricsTable(input, image ? &*image : nullptr)) +
        section("Forms tried", input.trials.empty() ? "" : trialsTable(input.trials)) +
        section("Samples", samplesTable(input)) +
        section("Material", materialTable(input.material) + secondsText(input.seconds));
    return "<!DOCTYPE html>\n" +
           element("html", "lang=\"en\"",
                   headOf(input) + element("body", "", element("main", "", body))) +
           "\n";
}

void writeReport(const ReportInput& input, const std::string& path)
{
    writeFile(path, reportHtml(input));
}

}  // namespace fbrdf
