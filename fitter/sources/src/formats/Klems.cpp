// Klems.cpp - WINDOW / Radiance BSDF XML on Klems' angle basis (LBNL; genBSDF), reflection only.
// AngleBasis: rings, each with nPhis patches between LowerTheta and UpperTheta degrees, patch k of
// n about azimuth 360 k / n; a basis with 145 patches is "LBNL/Klems Full". WavelengthDataBlock:
// WavelengthDataDirection "Reflection Front" or "Reflection Back" and ScatteringData, an n x n
// matrix in 1/sr, without the cosine: row = outgoing patch, column = incident patch
// (IncidentDataStructure Columns; Rows is the transpose). The incident patch's azimuth is that of
// PROPAGATION, so the source of patch j is at azimuth + 180 and the mirror of a patch is itself.
// Wavelength "Visible" is a luminance, and grey here; blocks "CIE-X", "CIE-Z" beside it are colour,
// with Visible as Y, and become linear sRGB. From the WINDOW 6 technical documentation, genBSDF's
// manual, and files of measured and simulated shades. FILE.xml takes the front, FILE.xml@back the
// back. `evaluate` is the patch that a pair falls into; the samples are the patches' centres.
#include <fbrdf/base/Text.h>
#include "Formats.h"
#include "SampleRow.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/sources/Spectrum.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <pugixml.hpp>

namespace fbrdf {
namespace {

constexpr size_t kMostPatches = 4096;

struct Ring {
    double theta = 0.0, lower = 0.0, upper = 0.0;  ///< degrees
    size_t phis = 1, first = 0;                    ///< patches, and the index of the first
};

struct Basis {
    std::vector<Ring> rings;
    size_t patches = 0;
};

/// One incident-outgoing matrix in 1/sr, outgoing x incident.
struct KlemsTable {
    Basis basis;
    std::vector<Vec3f> f;
};

/// Child element by name, whatever namespace prefix it has.
pugi::xml_node child(const pugi::xml_node& parent, const char* name)
{
    for (const pugi::xml_node node : parent.children()) {
        const std::string_view full = node.name();
        if (full.substr(full.find(':') + 1) == name || full == name) return node;
    }
    return {};
}

std::string textOf(const pugi::xml_node& parent, const char* name)
{
    return std::string(trimmed(child(parent, name).text().get()));
}

/// All elements of that name below a node, in document order.
void collect(const pugi::xml_node& parent, const char* name, std::vector<pugi::xml_node>& found)
{
    struct Walker : pugi::xml_tree_walker {
        const char* name;
        std::vector<pugi::xml_node>* found;
        bool for_each(pugi::xml_node& node) override
        {
            const std::string_view full = node.name();
            if (full == name || full.substr(full.find(':') + 1) == name) found->push_back(node);
            return true;
        }
    } walker;
    walker.name = name;
    walker.found = &found;
    pugi::xml_node root = parent;
    root.traverse(walker);
}

double numberOf(const InputFile& file, const pugi::xml_node& parent, const char* name)
{
    double value = 0.0;
    const std::string text = textOf(parent, name);
    if (!parseNumber(text, value) || !std::isfinite(value))
        throw inputError(
            file, std::string("found ") + inQuotes(text) + " as " + name + ", expected a number");
    return value;
}

Ring readRing(const InputFile& file, const pugi::xml_node& block, size_t first)
{
    const double phis = numberOf(file, block, "nPhis");
    const pugi::xml_node bounds = child(block, "ThetaBounds");
    Ring ring{numberOf(file, block, "Theta"), numberOf(file, bounds, "LowerTheta"),
              numberOf(file, bounds, "UpperTheta"), 1, first};
    if (!(phis >= 1.0 && phis <= 360.0) || phis != std::floor(phis) || !(ring.lower >= 0.0) ||
        !(ring.upper > ring.lower && ring.upper <= 90.0))
        throw inputError(file, "found a ring of " + std::to_string(phis) + " patches from " +
                                   std::to_string(ring.lower) + " to " +
                                   std::to_string(ring.upper) + " degrees");
    ring.phis = static_cast<size_t>(phis);
    return ring;
}

Basis readBasis(const InputFile& file, const pugi::xml_node& node)
{
    Basis basis;
    std::vector<pugi::xml_node> blocks;
    collect(node, "AngleBasisBlock", blocks);
    for (const pugi::xml_node& block : blocks) {
        basis.rings.push_back(readRing(file, block, basis.patches));
        basis.patches += basis.rings.back().phis;
        if (basis.patches > kMostPatches) throw inputError(file, "found over 4096 patches");
    }
    for (size_t i = 1; i < basis.rings.size(); ++i)
        if (basis.rings[i].lower < basis.rings[i - 1].upper)
            throw inputError(file, "found rings that overlap, expected ascending angles");
    return basis;
}

std::map<std::string, Basis> readBases(const InputFile& file, const pugi::xml_node& root)
{
    std::vector<pugi::xml_node> nodes;
    collect(root, "AngleBasis", nodes);
    std::map<std::string, Basis> bases;
    for (const pugi::xml_node& node : nodes)
        bases[textOf(node, "AngleBasisName")] = readBasis(file, node);
    return bases;
}

std::vector<double> readMatrix(const InputFile& file, const pugi::xml_node& block, size_t patches,
                               bool transposed)
{
    std::string numbers = child(block, "ScatteringData").text().get();
    std::replace(numbers.begin(), numbers.end(), ',', ' ');
    WordReader words(numbers);
    std::vector<double> matrix(patches * patches);
    std::string_view word;
    size_t count = 0;
    for (; words.next(word); ++count) {
        const size_t i = transposed ? count % patches * patches + count / patches : count;
        if (count < matrix.size() && !parseNumber(word, matrix[i]))
            throw inputError(file,
                             "found " + inQuotes(word) + " in ScatteringData, expected numbers");
    }
    if (count != matrix.size())
        throw inputError(file, "found " + std::to_string(count) +
                                   " numbers of ScatteringData, expected " +
                                   std::to_string(patches) + " x " + std::to_string(patches));
    return matrix;
}

/// The blocks of one side by wavelength.
std::map<std::string, pugi::xml_node> blocksOf(const pugi::xml_node& root, const std::string& side)
{
    std::vector<pugi::xml_node> wavelengths, blocks;
    collect(root, "WavelengthData", wavelengths);
    std::map<std::string, pugi::xml_node> found;
    for (const pugi::xml_node& wavelength : wavelengths) {
        blocks.clear();
        collect(wavelength, "WavelengthDataBlock", blocks);
        for (const pugi::xml_node& block : blocks)
            if (lowerCase(textOf(block, "WavelengthDataDirection")) == "reflection " + side)
                found.emplace(textOf(wavelength, "Wavelength"), block);
    }
    return found;
}

const Basis& basisOf(const InputFile& file, const std::map<std::string, Basis>& bases,
                     const pugi::xml_node& block)
{
    const std::string column = textOf(block, "ColumnAngleBasis");
    const std::string row = textOf(block, "RowAngleBasis");
    const auto found = bases.find(column);
    if (found == bases.end() || row != column || found->second.patches == 0)
        throw inputError(file, "found bases " + inQuotes(column) + " and " + inQuotes(row) +
                                   ", expected one AngleBasis for both");
    return found->second;
}

KlemsTable readTable(const InputFile& file, const pugi::xml_node& root, const std::string& side)
{
    const std::map<std::string, pugi::xml_node> blocks = blocksOf(root, side);
    const auto visible = blocks.find("Visible");
    if (visible == blocks.end())
        throw inputError(file, "found no visible 'Reflection " + side + "', expected it");
    std::vector<pugi::xml_node> structures;
    collect(root, "IncidentDataStructure", structures);
    const bool rows =
        !structures.empty() && trimmed(structures.front().text().get()) == std::string_view("Rows");
    KlemsTable table;
    table.basis = basisOf(file, readBases(file, root), visible->second);
    const size_t n = table.basis.patches;
    const std::vector<double> y = readMatrix(file, visible->second, n, rows);
    const auto x = blocks.find("CIE-X"), z = blocks.find("CIE-Z");
    for (const double value : y) table.f.push_back(Vec3f(static_cast<float>(value)));
    if (x == blocks.end() || z == blocks.end()) return table;
    const std::vector<double> xs = readMatrix(file, x->second, n, rows);
    const std::vector<double> zs = readMatrix(file, z->second, n, rows);
    for (size_t i = 0; i < y.size(); ++i)
        table.f[i] = Vec3f(linearSrgbFromXyz({xs[i], y[i], zs[i]}));
    return table;
}

Vec3d centreOf(const Basis& basis, size_t patch)
{
    const auto above = std::upper_bound(basis.rings.begin(), basis.rings.end(), patch,
                                        [](size_t p, const Ring& ring) { return p < ring.first; });
    const Ring& ring = *(above - 1);
    return directionFromDegrees(ring.theta, 360.0 * double(patch - ring.first) / double(ring.phis));
}

size_t patchOf(const Basis& basis, const Vec3d& w)
{
    const double theta = std::acos(std::clamp(w.z, -1.0, 1.0)) * 180.0 / kPi;
    const auto above = std::upper_bound(basis.rings.begin(), basis.rings.end() - 1, theta,
                                        [](double t, const Ring& ring) { return t < ring.upper; });
    const double turn = std::atan2(w.y, w.x) / (2.0 * kPi) * double(above->phis);
    const long phis = static_cast<long>(above->phis);
    return above->first + static_cast<size_t>((std::lround(turn) % phis + phis) % phis);
}

/// The source of an incident patch, whose azimuth is that of propagation.
Vec3d opposite(const Vec3d& w)
{
    return {-w.x, -w.y, w.z};
}

std::string sideOf(const FileRequest& request)
{
    std::string side = lowerCase(request.choice.empty() ? "front" : request.choice);
    if (side != "front" && side != "back")
        throw Error(ErrorKind::usage, request.file->path(),
                    "found " + inQuotes(request.choice) + ", expected front or back");
    return side;
}

SampleStream streamOf(const std::shared_ptr<const KlemsTable>& table)
{
    SampleStream stream;
    const size_t n = table->basis.patches;
    stream.rows = n * n;
    stream.read = [table, n](uint64_t first, size_t count, std::vector<Sample>& samples,
                             SampleReport& report) {
        for (size_t i = size_t(first); i < size_t(first) + count; ++i)
            addRow({centreOf(table->basis, i / n), opposite(centreOf(table->basis, i % n)),
                    Vec3d(table->f[i])},
                   samples, report);
    };
    return stream;
}

Vec3d evaluateKlems(const KlemsTable& table, const Vec3d& wo, const Vec3d& wi)
{
    if (wo.z <= 0.0 || wi.z <= 0.0) return Vec3d(0.0);
    const size_t row = patchOf(table.basis, wo), column = patchOf(table.basis, opposite(wi));
    const Vec3f f = table.f[row * table.basis.patches + column];
    const bool finite = std::isfinite(f.x) && std::isfinite(f.y) && std::isfinite(f.z);
    return finite ? glm::max(Vec3d(f), Vec3d(0.0)) : Vec3d(0.0);
}

}  // namespace

bool isKlems(const InputFile& file)
{
    const std::string_view head = file.bytes().substr(0, 4096);
    return looksLikeText(head) && head.find('<') != std::string_view::npos &&
           head.find("WindowElement") != std::string_view::npos;
}

Source readKlems(const FileRequest& request)
{
    const InputFile& file = *request.file;
    const std::string side = sideOf(request);
    pugi::xml_document document;
    const pugi::xml_parse_result parsed =
        document.load_buffer(file.bytes().data(), file.size(), pugi::parse_default);
    if (!parsed)
        throw inputError(file, uint64_t(parsed.offset),
                         std::string("found ") + parsed.description() + ", expected XML");
    const auto table = std::make_shared<const KlemsTable>(readTable(file, document, side));
    Source source;
    source.description = "Klems matrix of " + std::to_string(table->basis.patches) +
                         " patches, reflection " + side + ", 1/sr";
    source.evaluate = [table](const Vec3d& wo, const Vec3d& wi) {
        return evaluateKlems(*table, wo, wi);
    };
    source.stream = streamOf(table);
    return source;
}

}  // namespace fbrdf
