// TextTable.h - aligned columns of text, for people.
#pragma once
#include <string>
#include <vector>

namespace fbrdf::tool {

enum class Align { left, right };

/// Rows of cells, each column as wide as its widest cell, two spaces apart, after `indent` spaces.
/// Rows may be shorter than `columns`; the last column is not padded.
std::string alignedTable(const std::vector<Align>& columns,
                         const std::vector<std::vector<std::string>>& rows, int indent = 2);

/// `text` broken at spaces into lines of at most `width` characters (a longer word stays whole),
/// each after `indent` spaces and ended by a newline.
std::string wrapped(const std::string& text, int indent, int width = 96);

/// 1234567 as "1,234,567".
std::string withSeparators(unsigned long long number);

}  // namespace fbrdf::tool
