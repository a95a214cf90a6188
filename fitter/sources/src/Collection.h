// Collection.h - one material out of a file of many, by row or by name.
#pragma once
#include "Formats.h"

namespace fbrdf {

struct Chosen {
    size_t row = 0;
    std::string name;  ///< from materials.txt, or else "FILE#row"
};

/// Finds the row that the request asks for. Names are the lines of materials.txt beside the file,
/// "name" or "set name"; a choice is a row from 0, a name, or set/name where a name is in several
/// sets. Throws Error(usage) when nothing, or nothing that exists, was chosen; a file of one row
/// needs no choice.
Chosen chosenMaterial(const FileRequest& request, size_t rows);

/// What to write behind FILE# for each of the `rows` materials, or for those of the set that the
/// request asks for: a name, set/name where the name is in several sets, a row where there is no
/// name. Empty when the choice is a material and not a set.
std::vector<std::string> choicesOf(const FileRequest& request, size_t rows);

}  // namespace fbrdf
