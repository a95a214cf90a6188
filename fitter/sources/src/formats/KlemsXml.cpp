#include "formats/KlemsXml.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Text.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

/// An element takes 64 bytes of memory and more, a row of numbers some hundred bytes of the file:
/// files of data stay far below this share, and hostile ones cannot take 16 times their size.
constexpr size_t kBytesPerTag = 8, kTagsAllowed = 200000;

std::string_view withoutPrefix(std::string_view name)
{
    return name.substr(name.find(':') + 1);
}

/// "reflection front" of " Reflection   FRONT ".
std::string normalised(std::string_view text)
{
    std::vector<std::string_view> words;
    splitWords(text, words);
    std::string joined;
    for (const std::string_view word : words)
        joined += (joined.empty() ? "" : " ") + lowerCase(word);
    return joined;
}

std::string sideOfReflection(const KlemsBlock& block)
{
    const std::string direction = normalised(block.direction);
    if (direction == "reflection front") return "front";
    return direction == "reflection back" ? "back" : "";
}

const KlemsBlock* findBlock(const std::vector<KlemsBlock>& blocks, std::string_view side,
                            std::string_view band)
{
    for (const KlemsBlock& block : blocks)
        if (sideOfReflection(block) == side && sameWord(block.band, band)) return &block;
    return nullptr;
}

/// Visible is CIE-Y under another name.
const KlemsBlock* findLuminance(const std::vector<KlemsBlock>& blocks, std::string_view side)
{
    const KlemsBlock* visible = findBlock(blocks, side, "visible");
    return visible ? visible : findBlock(blocks, side, "cie-y");
}

bool hasSide(const std::vector<KlemsBlock>& blocks, std::string_view side)
{
    return std::any_of(blocks.begin(), blocks.end(),
                       [&](const KlemsBlock& block) { return sideOfReflection(block) == side; });
}

/// What the file has, as the user would ask for it.
std::string listOf(const std::vector<KlemsBlock>& blocks)
{
    constexpr size_t kLongest = 300;
    std::string list;
    for (const KlemsBlock& block : blocks) {
        const std::string side = sideOfReflection(block);
        if (list.size() > kLongest) return list + ", ...";
        list += list.empty() ? "" : ", ";
        list += side.empty() ? block.direction + " of " + block.band + " (not read)"
                             : "FILE@" + lowerCase(block.band) + "/" + side;
    }
    return list.empty() ? "no block of data" : list;
}

[[noreturn]] void failToSelect(const FileRequest& request, const KlemsChoice& choice,
                               const std::vector<KlemsBlock>& blocks)
{
    const bool chosen = !choice.band.empty() || !choice.side.empty();
    const std::string what = chosen ? "no " + (choice.band.empty() ? "visible" : choice.band) +
                                          " reflection" +
                                          (choice.side.empty() ? "" : " of the " + choice.side)
                                    : std::string("no visible reflection");
    throw Error(chosen ? ErrorKind::usage : ErrorKind::input, request.file->path(),
                Found(what).expected("a choice of what the file has: " + listOf(blocks)));
}

std::string chooseSide(const KlemsChoice& choice, const std::vector<KlemsBlock>& blocks,
                       std::vector<std::string>& assumptions)
{
    if (!choice.side.empty()) return choice.side;
    const bool front = hasSide(blocks, "front"), back = hasSide(blocks, "back");
    if (front == back) {
        if (front) assumptions.emplace_back("the front side; FILE@back takes the other");
        return "front";
    }
    assumptions.emplace_back(front ? "the front side, which alone is there"
                                   : "the back side, which alone is there");
    return front ? "front" : "back";
}

/// Other bands of the side, which a choice takes, and transmission, which none does.
void sayWhatIsLeft(const KlemsChoice& choice, const std::vector<KlemsBlock>& blocks,
                   KlemsSelection& selection)
{
    std::vector<std::string> bands;
    bool transmits = false;
    for (const KlemsBlock& block : blocks) {
        const std::string side = sideOfReflection(block), band = lowerCase(block.band);
        transmits |= side.empty();
        const bool isRead = &block == selection.y || &block == selection.x || &block == selection.z;
        if (side == selection.side && !isRead &&
            std::find(bands.begin(), bands.end(), band) == bands.end())
            bands.push_back(band);
    }
    std::string list;
    for (const std::string& band : bands) list += (list.empty() ? "FILE@" : ", FILE@") + band;
    if (choice.band.empty() && !list.empty())
        selection.assumptions.push_back("the visible band; others are " + list);
    if (transmits) selection.assumptions.emplace_back("the reflection; transmission is not read");
}

}  // namespace

void parseKlemsXml(const InputFile& file, pugi::xml_document& document)
{
    const std::string_view bytes = file.bytes();
    const auto tags = size_t(std::count(bytes.begin(), bytes.end(), '<'));
    if (tags > bytes.size() / kBytesPerTag + kTagsAllowed)
        throw inputError(file, Found(std::to_string(tags) + " elements in " +
                                     std::to_string(bytes.size()) + " bytes")
                                   .expected("mostly numbers"));
    const pugi::xml_parse_result parsed = document.load_buffer(bytes.data(), bytes.size());
    if (!parsed)
        throw inputError(file, uint64_t(parsed.offset),
                         Found(parsed.description()).expected("XML"));
}

std::string textWithin(const pugi::xml_node& node)
{
    std::string text;
    for (const pugi::xml_node part : node.children())
        if (part.type() == pugi::node_pcdata || part.type() == pugi::node_cdata)
            text += std::string(text.empty() ? "" : " ") + part.value();
    return text;
}

pugi::xml_node childNamed(const pugi::xml_node& parent, std::string_view name)
{
    for (const pugi::xml_node node : parent.children())
        if (sameWord(withoutPrefix(node.name()), name)) return node;
    return {};
}

std::string childText(const pugi::xml_node& parent, std::string_view name)
{
    const std::string text = textWithin(childNamed(parent, name));
    std::string_view content = text;
    while (!content.empty() && content.front() == '\n') content.remove_prefix(1);
    std::string line(content);
    std::replace(line.begin(), line.end(), '\n', ' ');
    return std::string(trimmed(line));
}

std::vector<pugi::xml_node> elementsNamed(const pugi::xml_node& parent, std::string_view name)
{
    struct Walker : pugi::xml_tree_walker {
        std::string_view name;
        std::vector<pugi::xml_node> found;
        bool for_each(pugi::xml_node& node) override
        {
            if (sameWord(withoutPrefix(node.name()), name)) found.push_back(node);
            return true;
        }
    } walker;
    walker.name = name;
    pugi::xml_node root = parent;
    root.traverse(walker);
    return walker.found;
}

double numberIn(const InputFile& file, const pugi::xml_node& parent, std::string_view name)
{
    double value = 0.0;
    const std::string text = childText(parent, name);
    if (!parseLocalNumber(text, value) || !std::isfinite(value))
        throw inputError(file,
                         Found(inQuotes(text) + " as " + std::string(name)).expected("a number"));
    return value;
}

KlemsChoice klemsChoice(const FileRequest& request)
{
    KlemsChoice choice;
    std::vector<std::string_view> words;
    splitFields(request.choice, '/', words);
    for (const std::string_view word : words) {
        const std::string name = normalised(word);
        std::string& part = name == "front" || name == "back" ? choice.side
                            : name == "d65" || name == "e"    ? choice.white
                                                              : choice.band;
        if (!part.empty())
            throw Error(ErrorKind::usage, request.file->path(),
                        Found("the choice " + inQuotes(request.choice))
                            .expected("a band, front or back, and d65 or e, each once"));
        part = name;
    }
    return choice;
}

std::vector<KlemsBlock> klemsBlocks(const pugi::xml_node& root)
{
    std::vector<KlemsBlock> blocks;
    for (const pugi::xml_node& wavelength : elementsNamed(root, "WavelengthData"))
        for (const pugi::xml_node& block : elementsNamed(wavelength, "WavelengthDataBlock"))
            blocks.push_back({childText(wavelength, "Wavelength"),
                              childText(block, "WavelengthDataDirection"), block});
    return blocks;
}

KlemsSelection selectBlocks(const FileRequest& request, const KlemsChoice& choice,
                            const std::vector<KlemsBlock>& blocks)
{
    KlemsSelection selection;
    selection.side = chooseSide(choice, blocks, selection.assumptions);
    const bool visible = choice.band.empty() || choice.band == "visible";
    selection.y = visible ? findLuminance(blocks, selection.side)
                          : findBlock(blocks, selection.side, choice.band);
    if (!selection.y && choice.side.empty() && hasSide(blocks, "back")) {
        // The band may be there on the other side alone.
        selection.y =
            visible ? findLuminance(blocks, "back") : findBlock(blocks, "back", choice.band);
        selection.side = "back";
        selection.assumptions = {"the back side, which alone has the band"};
    }
    if (!selection.y) failToSelect(request, choice, blocks);
    selection.band = selection.y->band;
    const KlemsBlock* x = findBlock(blocks, selection.side, "cie-x");
    const KlemsBlock* z = findBlock(blocks, selection.side, "cie-z");
    if (visible && x && z) {
        selection.x = x;
        selection.z = z;
    }
    sayWhatIsLeft(choice, blocks, selection);
    return selection;
}

}  // namespace fbrdf
