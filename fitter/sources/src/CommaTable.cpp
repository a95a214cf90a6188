#include "CommaTable.h"

#include <algorithm>

namespace fbrdf {
namespace {

std::vector<std::string> namesIn(std::string_view line)
{
    std::vector<std::string_view> fields;
    splitFields(line, ',', fields);
    std::vector<std::string> names;
    names.reserve(fields.size());
    for (const std::string_view field : fields) names.push_back(lowerCase(field));
    return names;
}

std::vector<std::string> readNames(const InputFile& file, LineReader& lines)
{
    std::string_view line;
    if (!lines.nextData(line)) throw inputError(file, "found no line of data, expected a header");
    return namesIn(line);
}

}  // namespace

std::vector<std::string> columnNamesOf(std::string_view text)
{
    LineReader lines(text);
    std::string_view line;
    return lines.nextData(line) ? namesIn(line) : std::vector<std::string>();
}

CommaTable::CommaTable(const InputFile& file, const std::vector<std::string>& columns)
    : file_(file), lines_(file.bytes()), values_(columns.size()), names_(readNames(file, lines_))
{
    for (const std::string& column : columns) {
        const auto found = std::find(names_.begin(), names_.end(), column);
        if (found == names_.end())
            throw lineError(file, lines_.number(), "found no column '" + column + "', expected it");
        columns_.push_back(size_t(found - names_.begin()));
    }
}

CommaTable::CommaTable(const InputFile& file, const std::vector<size_t>& columns)
    : file_(file),
      lines_(file.bytes()),
      columns_(columns),
      values_(columns.size()),
      names_(readNames(file, lines_))
{
    if (*std::max_element(columns.begin(), columns.end()) >= names_.size())
        throw lineError(file, lines_.number(),
                        "found " + std::to_string(names_.size()) + " columns, expected more");
}

bool CommaTable::next()
{
    std::string_view line;
    if (!lines_.nextData(line)) return false;
    splitFields(line, ',', fields_);
    if (fields_.size() != names_.size())
        throw lineError(file_, lines_.number(),
                        "found " + std::to_string(fields_.size()) + " fields, expected " +
                            std::to_string(names_.size()) + " as in the header");
    for (size_t i = 0; i < columns_.size(); ++i)
        if (!parseNumber(fields_[columns_[i]], values_[i]))
            throw lineError(file_, lines_.number(),
                            "found " + quoted(fields_[columns_[i]]) + " as " + names_[columns_[i]] +
                                ", expected a number");
    return true;
}

}  // namespace fbrdf
