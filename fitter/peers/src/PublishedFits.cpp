#include <fbrdf/peers/PublishedFits.h>

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Number.h>
#include <fbrdf/base/Text.h>
#include <fbrdf/sources/Fields.h>

#include <cmath>
#include <fstream>

namespace fbrdf {
namespace {

constexpr int kExact = 17;  // digits that give every double back

std::vector<std::string> fieldsOf(const std::string& line)
{
    std::vector<std::string_view> fields;
    splitFields(line, Separator::comma, fields);
    return {fields.begin(), fields.end()};
}

double numberOf(const std::string& text, const std::string& where)
{
    double value = 0.0;
    if (!parseNumber(text, value) || !std::isfinite(value))
        throw Error(ErrorKind::input, where, Found("'" + text + "'").expected("a number"));
    return value;
}

ParameterRow rowOf(const std::vector<std::string>& header, const std::vector<std::string>& fields,
                   const std::string& where)
{
    if (fields.size() != header.size())
        throw Error(ErrorKind::input, where,
                    Found(std::to_string(fields.size()) + " fields")
                        .expected(std::to_string(header.size())));
    ParameterRow row;
    for (size_t i = 1; i < fields.size(); ++i) row[header[i]] = numberOf(fields[i], where);
    return row;
}

}  // namespace

ParameterRow publishedRow(const std::string& path, const std::string& material)
{
    std::ifstream file(path);
    std::string line;
    if (!std::getline(file, line)) return {};
    const std::vector<std::string> header = fieldsOf(line);
    for (size_t number = 2; std::getline(file, line); ++number) {
        const std::vector<std::string> fields = fieldsOf(line);
        if (!fields.empty() && fields[0] == material)
            return rowOf(header, fields, path + ":" + std::to_string(number));
    }
    return {};
}

std::string specFromRow(const std::string& model, const ParameterRow& row,
                        const std::vector<std::pair<std::string, std::string>>& parameters)
{
    const auto at = [&](const std::string& column) {
        const auto found = row.find(column);
        if (found == row.end())
            throw Error(ErrorKind::input, model, Found("no column " + column).expected("one"));
        return numberText(found->second, kExact);
    };
    std::string spec = model;
    for (const auto& [key, column] : parameters) {
        spec += (spec == model ? ":" : ",") + key + "=";
        spec += row.count(column) > 0
                    ? at(column)
                    : at(column + "_r") + "/" + at(column + "_g") + "/" + at(column + "_b");
    }
    return spec;
}

}  // namespace fbrdf
