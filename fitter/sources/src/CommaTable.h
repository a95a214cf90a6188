// CommaTable.h - tables of comma-separated numbers under a line of names, as measurement groups
// publish them. Each reader names the columns that it needs; the others are skipped.
#pragma once
#include "InputFile.h"
#include "Text.h"

namespace fbrdf {

/// Names of the first line that is neither blank nor a '#' comment, lower case.
std::vector<std::string> columnNamesOf(std::string_view text);

class CommaTable {
public:
    /// `columns` - the fields that are read, by position or by name. Throws Error(input) for a name
    /// that the header has not.
    CommaTable(const InputFile& file, const std::vector<std::string>& columns);
    CommaTable(const InputFile& file, const std::vector<size_t>& columns);

    /// False at the end. Throws Error(input) at a line with another number of fields than the
    /// header, or a field that is no number.
    bool next();
    /// Value of the i-th of `columns` in the row that was read last.
    double operator[](size_t i) const { return values_[i]; }

private:
    const InputFile& file_;
    LineReader lines_;
    std::vector<size_t> columns_;
    std::vector<double> values_;
    std::vector<std::string> names_;
    std::vector<std::string_view> fields_;
};

}  // namespace fbrdf
