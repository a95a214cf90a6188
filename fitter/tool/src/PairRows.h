// PairRows.h - direction pairs as CSV: header wo_x,wo_y,wo_z,wi_x,wi_y,wi_z in any order among any
// further columns, separated and quoted by the rules of Fields.h. Blank lines and lines that start
// with '#' are skipped.
#pragma once
#include <fbrdf/brdf/Conventions.h>
#include <fbrdf/sources/Fields.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace fbrdf::tool {

/// Takes the first line off `text` and returns it without its end ("\n" or "\r\n").
std::string_view takeLine(std::string_view& text);
/// True for a blank line and for a comment.
bool isSkipped(std::string_view line);

class PairRows {
public:
    /// Throws Error(input) naming `where` for a header without the six columns or with one twice.
    PairRows(std::string_view header, const std::string& where);

    /// The pair of a row, normalised. Returns an empty string, or what is wrong with the row.
    std::string parse(std::string_view line, DirectionPair<double>& pair) const;

private:
    Separator separator_;
    std::vector<int> componentOfField_;  // 0..5, or -1 for a column that is not read
};

}  // namespace fbrdf::tool
