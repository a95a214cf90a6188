// NamedTable.h - tables of text under a line of names, as spreadsheets, R and pandas write them and
// measurement groups publish them. Separators, quotes and missing values are as in Fields.h; the
// line of names decides on the separator. A first line "sep=;", which Excel understands, does too.
// Rows between blanks may start with one field more than there are names: the name of the row,
// which R writes.
#pragma once
#include "InputFile.h"

#include <fbrdf/base/Text.h>
#include <fbrdf/sources/Fields.h>

namespace fbrdf {

class NamedTable {
public:
    /// Reads the line of names. Throws Error(input) where there is none.
    explicit NamedTable(const InputFile& file);

    /// The names as written, without quotes.
    const std::vector<std::string>& names() const { return names_; }
    /// Index of a name in any case. Throws Error(input) where it is missing.
    size_t column(std::string_view name) const;
    Separator separator() const { return separator_; }
    /// Number of the line that was read last, from 1.
    size_t line() const { return lines_.number(); }

    /// False at the end. Throws Error(input) for a row with fewer fields than there are names, or
    /// with more of which one has a value.
    bool next();
    /// A field of the row that was read last as a number; NaN where it is missing. Throws
    /// Error(input) for anything else.
    double number(size_t column) const;

private:
    void requireFields() const;

    const InputFile& file_;
    LineReader lines_;
    Separator separator_ = Separator::comma;
    std::vector<std::string> names_;
    std::vector<std::string_view> fields_;
    size_t first_ = 0;  ///< fields before that of the first name
};

/// Names in the first line of a text that is neither blank nor a '#' comment, lower case.
std::vector<std::string> columnNamesOf(std::string_view text);

}  // namespace fbrdf
