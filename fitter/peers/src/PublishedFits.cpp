#include <fbrdf/peers/PublishedFits.h>

#include <fbrdf/base/Error.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace fbrdf {
namespace {

std::vector<std::string> fieldsOf(const std::string& line)
{
    std::vector<std::string> fields;
    std::istringstream text(line);
    for (std::string field; std::getline(text, field, ',');) fields.push_back(field);
    return fields;
}

double numberOf(const std::string& text, const std::string& where)
{
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (end == text.c_str() || *end != '\0' || !std::isfinite(value))
        throw Error(ErrorKind::input, where, "found '" + text + "', expected a number");
    return value;
}

ParameterRow rowOf(const std::vector<std::string>& header, const std::vector<std::string>& fields,
                   const std::string& where)
{
    if (fields.size() != header.size())
        throw Error(ErrorKind::input, where,
                    "found " + std::to_string(fields.size()) + " fields, expected " +
                        std::to_string(header.size()));
    ParameterRow row;
    for (size_t i = 1; i < fields.size(); ++i) row[header[i]] = numberOf(fields[i], where);
    return row;
}

std::string exactText(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", value);
    return text;
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
            throw Error(ErrorKind::input, model, "found no column " + column + ", expected one");
        return exactText(found->second);
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
