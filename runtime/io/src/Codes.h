// Codes.h - tables to the integers that files store and back, with every check that a hostile file
// calls for.
#pragma once
#include <fbrdf/base/Error.h>
#include <fbrdf/brdf/Table.h>

#include <cstdint>
#include <string>
#include <vector>

namespace fbrdf {

/// Sets `storage` and returns true when the name is one of storageName's.
bool knownStorage(const std::string& name, Storage& storage);

/// codeOf for every texel: texels x channels, in the order of Table::texels.
std::vector<uint16_t> codesOfTable(const Table& table);

/// Throws Error(input) that names `where` unless quantized() could have set this range and Log8:
/// then no sum of codes overflows.
void checkCoding(const Table& table, const std::string& where);

/// Replaces the codes in `table.texels` by the texels that they stand for. Call checkCoding first.
/// Throws Error(input) that names `where` for a code that is not an integer from 0 to 255 or leads
/// out of the range.
void decodeTexels(Table& table, const std::string& where);

/// Table::unsupported as the text of docs/format.md, section Storages ("5 2 9"), and back. Throws
/// Error(input) that names `where` unless the lengths add up to `texels`.
std::string runsOfMarks(const std::vector<bool>& marks);
std::vector<bool> marksFromRuns(const std::string& runs, int texels, const std::string& where);

/// Throws Error(kind) that names `where` and the table unless its storage can represent every texel
/// exactly, which is so for tables that quantized() returned.
void checkStorable(const Table& table, ErrorKind kind, const std::string& where);

}  // namespace fbrdf
