#include "batch/BatchResults.h"

#include "CsvText.h"
#include "Errors.h"
#include "FitJob.h"

#include <fmt/format.h>

namespace fbrdf::tool {
namespace {

// Errors on samples come twice, the others once.
std::vector<std::string> errorColumns()
{
    std::vector<std::string> columns;
    const auto& names = errorNames();
    const ErrorMap ofSamples = named(SampleErrors{});
    for (const char* prefix : {kHeldOutPrefix, kAllPrefix})
        for (const std::string& name : names)
            if (ofSamples.count(name) > 0) columns.push_back(prefix + name);
    for (const std::string& name : names)
        if (ofSamples.count(name) == 0) columns.push_back(name);
    return columns;
}

const std::vector<const char*>& noteColumns()
{
    static const std::vector<const char*> keys{kUsedNote, kInvalidNote, kBelowFloorNote,
                                               kSmoothnessNote};
    return keys;
}

std::string noteOf(const Material& material, const std::string& key)
{
    const auto found = material.notes.find(key);
    return found == material.notes.end() ? "" : found->second;
}

std::string errorOf(const Material& material, const std::string& key)
{
    const auto found = material.errors.find(key);
    return found == material.errors.end() ? "" : fmt::format("{}", found->second);
}

}  // namespace

std::string resultsHeader()
{
    std::vector<std::string> fields{"name", "source", "form", "bytes", "lookups"};
    for (const std::string key : noteColumns()) {
        std::string column = key;
        for (char& c : column)
            if (c == ' ') c = '_';
        fields.push_back(column);
    }
    for (const std::string& column : errorColumns()) fields.push_back(column);
    fields.push_back("error");
    return csvLine(fields);
}

std::string resultsRow(const BatchItem& item, const Material& material)
{
    std::vector<std::string> fields{item.name, item.source, material.form.name,
                                    fmt::format("{}", materialBytes(material)),
                                    fmt::format("{}", lookupsPerLight(material.form))};
    for (const char* key : noteColumns()) fields.push_back(noteOf(material, key));
    for (const std::string& key : errorColumns()) fields.push_back(errorOf(material, key));
    fields.emplace_back();
    return csvLine(fields);
}

std::string failureRow(const BatchItem& item, const std::string& error)
{
    std::vector<std::string> fields{item.name, item.source};
    fields.resize(5 + noteColumns().size() + errorColumns().size());
    fields.push_back(error);
    return csvLine(fields);
}

}  // namespace fbrdf::tool
