// Klems.cpp - BSDF XML of WINDOW (LBNL) and Radiance (genBSDF, bsdf2ttree), reflection only.
// IncidentDataStructure is Columns or Rows (a matrix over an angle basis, KlemsBasis.h, that has
// the incident patches in its columns or rows), or TensorTree3 or TensorTree4 (TensorTree.h); words
// are compared without case. WavelengthData: a Wavelength, and blocks WavelengthDataBlock, each
// with WavelengthDataDirection "Reflection Front" or "Reflection Back", ColumnAngleBasis,
// RowAngleBasis and ScatteringData in 1/sr, without the cosine. The incident patch's azimuth is
// that of PROPAGATION, so the source of patch j is at azimuth + 180 and the mirror of a patch is
// itself. Wavelength "Visible" is a luminance, and grey here; blocks "CIE-X", "CIE-Z" beside it are
// colour, with Visible as Y, and become linear sRGB. Radiance computes them so that grey has X = Y
// = Z; a table whose sums have the proportions of D65 is taken to have that white. From the WINDOW
// 6 technical documentation, the manuals and sources of Radiance, and files of measured and
// simulated shades. FILE@BAND/SIDE/WHITE chooses: a Wavelength, front or back, d65 or e. `evaluate`
// is the patch or cell that a pair falls into; the samples of a matrix are the patches' centres,
// and a tree has none.
#include "formats/KlemsBasis.h"
#include "formats/KlemsXml.h"
#include "formats/TensorTree.h"
#include "SampleRow.h"
#include "Tristimulus.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Text.h>
#include <fbrdf/sources/Fields.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace fbrdf {
namespace {

/// One matrix in 1/sr, outgoing x incident.
struct KlemsTable {
    KlemsBasis outgoing, incident;
    std::vector<Vec3f> f;
};

struct KlemsTrees {
    std::unique_ptr<TensorTree> x, y, z;  ///< x and z are null where there is no colour
    XyzWhite white = XyzWhite::equalEnergy;
};

enum class Structure { columns, rows, tree3, tree4 };

Structure structureOf(const InputFile& file, const pugi::xml_node& root,
                      std::vector<std::string>& assumptions)
{
    const std::vector<pugi::xml_node> found = elementsNamed(root, "IncidentDataStructure");
    const std::string text = found.empty() ? "" : textWithin(found.front());
    std::vector<std::string_view> words;
    std::string flat = text;
    std::replace(flat.begin(), flat.end(), '\n', ' ');
    splitWords(flat, words);
    const std::string word = words.size() == 1 ? lowerCase(words.front()) : lowerCase(flat);
    if (found.empty() || words.empty()) {
        assumptions.emplace_back("incident patches in columns");
        return Structure::columns;
    }
    if (word == "columns") return Structure::columns;
    if (word == "rows") return Structure::rows;
    if (word == "tensortree3") return Structure::tree3;
    if (word == "tensortree4") return Structure::tree4;
    throw inputError(file, Found("the IncidentDataStructure " + inQuotes(trimmed(flat)))
                               .expected("Columns, Rows, TensorTree3 or TensorTree4"));
}

const KlemsBasis& basisNamed(const InputFile& file, const std::map<std::string, KlemsBasis>& bases,
                             const pugi::xml_node& block, const char* element)
{
    const std::string name = childText(block, element);
    const auto found = bases.find(lowerCase(name));
    if (found != bases.end()) return found->second;
    throw inputError(
        file, Found("the " + std::string(element) + " " + inQuotes(name))
                  .expected("an AngleBasis of the file or LBNL/Klems Full, Half or Quarter"));
}

/// The numbers of a block's ScatteringData, in their order.
std::vector<double> readNumbers(const InputFile& file, const pugi::xml_node& block, size_t rows,
                                size_t columns)
{
    std::string numbers = textWithin(childNamed(block, "ScatteringData"));
    std::replace_if(
        numbers.begin(), numbers.end(), [](char c) { return c == ',' || c == ';'; }, ' ');
    WordReader words(numbers);
    std::vector<double> values;
    values.reserve(rows * columns);
    size_t count = 0;
    for (std::string_view word; words.next(word); ++count) {
        if (count == rows * columns) continue;
        values.push_back(0.0);
        if (!parseField(word, values.back()))
            throw inputError(file,
                             Found(inQuotes(word) + " in ScatteringData").expected("numbers"));
    }
    if (count != rows * columns)
        throw inputError(file,
                         Found(std::to_string(count) + " numbers of ScatteringData")
                             .expected(std::to_string(rows) + " x " + std::to_string(columns)));
    return values;
}

/// Reads one matrix as outgoing x incident and checks its bases against those of the table.
std::vector<double> readMatrix(const InputFile& file, const KlemsBlock& block,
                               const KlemsTable& table, Structure structure)
{
    const size_t out = table.outgoing.patches(), in = table.incident.patches();
    const bool rows = structure == Structure::rows;
    std::vector<double> numbers = readNumbers(file, block.node, rows ? in : out, rows ? out : in);
    if (!rows) return numbers;
    std::vector<double> matrix(numbers.size());
    for (size_t i = 0; i < numbers.size(); ++i) matrix[i % out * in + i / out] = numbers[i];
    return matrix;
}

KlemsTable readTable(const InputFile& file, const pugi::xml_node& root, Structure structure,
                     const KlemsChoice& choice, KlemsSelection& selection)
{
    const std::map<std::string, KlemsBasis> bases = klemsBases(file, root);
    const KlemsBasis& column = basisNamed(file, bases, selection.y->node, "ColumnAngleBasis");
    const KlemsBasis& row = basisNamed(file, bases, selection.y->node, "RowAngleBasis");
    KlemsTable table;
    table.incident = structure == Structure::rows ? row : column;
    table.outgoing = structure == Structure::rows ? column : row;
    const std::vector<double> y = readMatrix(file, *selection.y, table, structure);
    for (const double value : y) table.f.push_back(Vec3f(static_cast<float>(value)));
    if (!selection.x) return table;
    const std::vector<double> x = readMatrix(file, *selection.x, table, structure);
    const std::vector<double> z = readMatrix(file, *selection.z, table, structure);
    Vec3d sums(0.0);
    for (size_t i = 0; i < y.size(); ++i) sums += Vec3d(x[i], y[i], z[i]);
    const XyzWhite white = whiteOfXyz(choice.white, sums, selection.assumptions);
    for (size_t i = 0; i < y.size(); ++i)
        table.f[i] = Vec3f(linearSrgbFromXyz({x[i], y[i], z[i]}, white));
    return table;
}

/// The source of an incident patch, whose azimuth is that of propagation.
Vec3d opposite(const Vec3d& w)
{
    return {-w.x, -w.y, w.z};
}

SampleStream streamOf(const std::shared_ptr<const KlemsTable>& table)
{
    SampleStream stream;
    stream.rows = table->f.size();
    stream.read = [table](uint64_t first, size_t count, std::vector<Sample>& samples,
                          SampleReport& report) {
        const size_t in = table->incident.patches();
        for (size_t i = size_t(first); i < size_t(first) + count; ++i)
            addRow({table->outgoing.centre(i / in), opposite(table->incident.centre(i % in)),
                    Vec3d(table->f[i])},
                   samples, report);
    };
    return stream;
}

Vec3d evaluateKlems(const KlemsTable& table, const Vec3d& wo, const Vec3d& wi)
{
    if (wo.z <= 0.0 || wi.z <= 0.0) return Vec3d(0.0);
    const size_t row = table.outgoing.patchOf(wo), column = table.incident.patchOf(opposite(wi));
    const Vec3f f = table.f[row * table.incident.patches() + column];
    const bool finite = std::isfinite(f.x) && std::isfinite(f.y) && std::isfinite(f.z);
    return finite ? glm::max(Vec3d(f), Vec3d(0.0)) : Vec3d(0.0);
}

Source sourceOfTable(KlemsTable read)
{
    const auto table = std::make_shared<const KlemsTable>(std::move(read));
    const size_t out = table->outgoing.patches(), in = table->incident.patches();
    Source source;
    source.description = "Klems matrix of " + std::to_string(out) +
                         (out == in ? "" : " outgoing and " + std::to_string(in) + " incident") +
                         " patches";
    source.evaluate = [table](const Vec3d& wo, const Vec3d& wi) {
        return evaluateKlems(*table, wo, wi);
    };
    source.stream = streamOf(table);
    return source;
}

std::unique_ptr<TensorTree> readTree(const InputFile& file, const KlemsBlock* block, int rank)
{
    if (!block) return nullptr;
    const std::string text = textWithin(childNamed(block->node, "ScatteringData"));
    return std::make_unique<TensorTree>(file, text, rank);
}

Vec3d evaluateTrees(const KlemsTrees& trees, const Vec3d& wo, const Vec3d& wi)
{
    if (wo.z <= 0.0 || wi.z <= 0.0) return Vec3d(0.0);
    const double y = (*trees.y)(wo, wi);
    if (!trees.x) return Vec3d(std::max(y, 0.0));
    const Vec3d xyz((*trees.x)(wo, wi), y, (*trees.z)(wo, wi));
    return glm::max(linearSrgbFromXyz(xyz, trees.white), Vec3d(0.0));
}

Source sourceOfTrees(const InputFile& file, int rank, const KlemsChoice& choice,
                     KlemsSelection& selection)
{
    const auto trees = std::make_shared<KlemsTrees>();
    trees->y = readTree(file, selection.y, rank);
    trees->x = readTree(file, selection.x, rank);
    trees->z = readTree(file, selection.z, rank);
    if (trees->x)
        trees->white =
            whiteOfXyz(choice.white, {trees->x->mean(), trees->y->mean(), trees->z->mean()},
                       selection.assumptions);
    Source source;
    source.description = "tensor tree of rank " + std::to_string(rank) + ", " +
                         std::to_string(trees->y->size()) + " values";
    source.isotropic = rank == 3;
    source.evaluate = [trees](const Vec3d& wo, const Vec3d& wi) {
        return evaluateTrees(*trees, wo, wi);
    };
    return source;
}

}  // namespace

bool isKlems(const InputFile& file)
{
    const std::string_view head = file.bytes().substr(0, 4096);
    return looksLikeText(head) && head.find('<') != std::string_view::npos &&
           lowerCase(head).find("windowelement") != std::string::npos;
}

Source readKlems(const FileRequest& request)
{
    const InputFile& file = *request.file;
    const KlemsChoice choice = klemsChoice(request);
    pugi::xml_document document;
    parseKlemsXml(file, document);
    const std::vector<KlemsBlock> blocks = klemsBlocks(document);
    KlemsSelection selection = selectBlocks(request, choice, blocks);
    const Structure structure = structureOf(file, document, selection.assumptions);
    const bool matrix = structure == Structure::columns || structure == Structure::rows;
    Source source =
        matrix ? sourceOfTable(readTable(file, document, structure, choice, selection))
               : sourceOfTrees(file, structure == Structure::tree3 ? 3 : 4, choice, selection);
    source.description += ", reflection " + selection.side + ", " +
                          (selection.x ? "XYZ to linear sRGB" : selection.band) + ", 1/sr";
    if (!selection.x) selection.assumptions.push_back("the band " + selection.band + " as grey");
    source.assumptions = selection.assumptions;
    return source;
}

}  // namespace fbrdf
