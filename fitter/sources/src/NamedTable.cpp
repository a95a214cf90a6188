#include "NamedTable.h"

#include <fbrdf/base/Found.h>

#include <algorithm>

namespace fbrdf {
namespace {

/// The line of names and its separator. False where the text has none.
bool readHeader(LineReader& lines, std::string_view& header, Separator& separator)
{
    if (!lines.nextRecord(header)) return false;
    const std::string_view line = trimmed(header);
    const bool declares = line.size() == 5 && sameWord(line.substr(0, 4), "sep=");
    if (declares && !lines.nextRecord(header)) return false;
    separator = separatorOfNames(declares ? line.substr(4) : header);
    return true;
}

std::vector<std::string> namesIn(std::string_view header, Separator separator)
{
    std::vector<std::string_view> fields;
    splitFields(header, separator, fields);
    return {fields.begin(), fields.end()};
}

}  // namespace

std::vector<std::string> columnNamesOf(std::string_view text)
{
    LineReader lines(text);
    std::string_view header;
    Separator separator = Separator::comma;
    if (!readHeader(lines, header, separator)) return {};
    std::vector<std::string> names = namesIn(header, separator);
    for (std::string& name : names) name = lowerCase(name);
    return names;
}

NamedTable::NamedTable(const InputFile& file) : file_(file), lines_(file.bytes())
{
    std::string_view header;
    if (!readHeader(lines_, header, separator_))
        throw inputError(file, Found("no line of data").expected("a header"));
    names_ = namesIn(header, separator_);
}

size_t NamedTable::column(std::string_view name) const
{
    const auto found = std::find_if(names_.begin(), names_.end(),
                                    [&](const std::string& n) { return sameWord(n, name); });
    if (found == names_.end())
        throw lineError(file_, lines_.number(),
                        Found("no column '" + std::string(name) + "'").expected("it"));
    return size_t(found - names_.begin());
}

bool NamedTable::next()
{
    std::string_view record;
    if (!lines_.nextRecord(record)) return false;
    splitFields(record, separator_, fields_);
    first_ = separator_ == Separator::blanks && fields_.size() == names_.size() + 1 ? 1 : 0;
    requireFields();
    return true;
}

void NamedTable::requireFields() const
{
    const size_t expected = names_.size() + first_;
    const bool empty =
        std::all_of(fields_.begin() + std::ptrdiff_t(std::min(expected, fields_.size())),
                    fields_.end(), [](std::string_view field) { return field.empty(); });
    if (fields_.size() >= expected && empty) return;
    throw lineError(file_, lines_.number(),
                    Found(std::to_string(fields_.size()) + " fields between " + nameOf(separator_))
                        .expected(std::to_string(names_.size()) + " as in the header"));
}

double NamedTable::number(size_t column) const
{
    const std::string_view field = fields_[first_ + column];
    double value = 0.0;
    if (!parseField(field, value))
        throw lineError(
            file_, lines_.number(),
            Found(inQuotes(field) + " as " + lowerCase(names_[column])).expected("a number"));
    return value;
}

}  // namespace fbrdf
