// Codes.h - stored integers of whole tables, both ways, with every check that a hostile file needs.
#pragma once
#include <fbrdf/base/Error.h>
#include <fbrdf/brdf/Table.h>

#include <cstdint>
#include <string>
#include <vector>

namespace fbrdf {

/// Sets `storage` and returns true when the name is one of storageName's.
bool knownStorage(const std::string& name, Storage& storage);

/// codeOf every texel: texels x channels, as Table::texels.
std::vector<uint16_t> codesOfTable(const Table& table);

/// Throws Error(input) naming `where` unless range and Log8 are ones that quantized() could have
/// set: within them no sum of codes overflows.
void checkCoding(const Table& table, const std::string& where);

/// Replaces the codes that `table.texels` holds by what they mean; checkCoding first. Throws
/// Error(input) naming `where` for a code that is not an integer of 0..255 or leaves the range.
void decodeTexels(Table& table, const std::string& where);

/// Table::unsupported as text: lengths of runs, the first of texels without a mark ("5 2 9"); back,
/// throwing Error(input) naming `where` unless they add up to `texels`.
std::string runsOfMarks(const std::vector<bool>& marks);
std::vector<bool> marksFromRuns(const std::string& runs, int texels, const std::string& where);

/// Throws Error(kind) naming `where` and the table unless its storage holds its texels exactly, as
/// those of quantized() are.
void checkStorable(const Table& table, ErrorKind kind, const std::string& where);

}  // namespace fbrdf
