// KlemsXml.h - the XML of WINDOW and Radiance as blocks of data: which side, which band, what text.
// Names of elements and words of the format are compared without case, as Radiance compares words.
#pragma once
#include "Formats.h"

#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace fbrdf {

/// One WavelengthDataBlock.
struct KlemsBlock {
    std::string band;       ///< "Visible", "Solar", "CIE-X", "550", as written
    std::string direction;  ///< "Reflection Front", as written
    pugi::xml_node node;
};

/// What FILE@CHOICE of such a file asks for: words between '/', such as "solar/back" or "back/d65".
struct KlemsChoice {
    std::string band;   ///< lower case, empty for the default
    std::string side;   ///< "front", "back", empty for the default
    std::string white;  ///< "d65", "e", empty for what the data suggest
};

/// Throws Error(input) for bytes that are no XML, or more markup than data.
void parseKlemsXml(const InputFile& file, pugi::xml_document& document);

/// The text of all parts of an element, comments between them left out. Empty where it is missing.
std::string textWithin(const pugi::xml_node& node);
/// First child of that name, whatever its namespace prefix.
pugi::xml_node childNamed(const pugi::xml_node& parent, std::string_view name);
/// The text of the element, trimmed.
std::string childText(const pugi::xml_node& parent, std::string_view name);
/// All elements of that name below a node, in document order.
std::vector<pugi::xml_node> elementsNamed(const pugi::xml_node& parent, std::string_view name);
/// A finite number in a child. Throws Error(input).
double numberIn(const InputFile& file, const pugi::xml_node& parent, std::string_view name);

/// Splits the choice of a request. Throws Error(usage) for a word given twice.
KlemsChoice klemsChoice(const FileRequest& request);

/// The blocks of one side that are read together.
struct KlemsSelection {
    std::string side;  ///< "front" or "back"
    std::string band;  ///< as written in the file
    const KlemsBlock* y = nullptr;
    const KlemsBlock* x = nullptr;  ///< null, as z, where there is no colour
    const KlemsBlock* z = nullptr;
    std::vector<std::string> assumptions;
};

std::vector<KlemsBlock> klemsBlocks(const pugi::xml_node& root);

/// Chooses among the blocks. Without a choice the side is the front, or the back where that alone
/// is there, and the band is Visible. Throws Error(usage) for a choice that the file has not, and
/// Error(input) where there is no default; both list what the file has.
KlemsSelection selectBlocks(const FileRequest& request, const KlemsChoice& choice,
                            const std::vector<KlemsBlock>& blocks);

}  // namespace fbrdf
