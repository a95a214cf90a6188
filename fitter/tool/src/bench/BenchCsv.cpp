#include "bench/BenchCsv.h"

#include "CsvText.h"
#include "Output.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Text.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

namespace fbrdf::tool {
namespace {

using Fields = std::vector<std::string>;

constexpr size_t kFixed = 8;  // columns before the errors

std::string header()
{
    Fields fields{"source", "material", "name", "peer", "bytes", "lookups", "seconds", "note"};
    for (const std::string& name : errorNames()) fields.push_back(name);
    return csvLine(fields);
}

Fields fieldsOf(const MaterialScores& material, const Score& score)
{
    Fields fields{material.source,
                  material.name,
                  score.contender.label,
                  score.contender.ours ? "0" : "1",
                  fmt::format("{}", score.bytes),
                  fmt::format("{}", score.lookups),
                  fmt::format("{:.4f}", score.seconds),
                  oneLine(score.note)};
    for (const std::string& name : errorNames()) {
        const auto found = score.errors.find(name);
        fields.push_back(found == score.errors.end() ? "" : fmt::format("{:.6g}", found->second));
    }
    return fields;
}

Fields emptyFields(const MaterialScores& material, const Contender& contender)
{
    Fields fields{material.source, material.name, contender.label, contender.ours ? "0" : "1"};
    fields.resize(kFixed + errorNames().size());
    return fields;
}

const Score* scoreOf(const MaterialScores& material, const Contender& contender)
{
    for (const Score& score : material.scores)
        if (sameContender(score.contender, contender)) return &score;
    return nullptr;
}

/// 0 where the field has no number.
double numberIn(const std::string& field)
{
    double value = 0.0;
    return parseNumber(field, value) ? value : 0.0;
}

Score scoreFrom(const Contender& contender, const Fields& fields)
{
    Score score{contender,
                std::strtoull(fields[4].c_str(), nullptr, 10),
                std::atoi(fields[5].c_str()),
                numberIn(fields[6]),
                {},
                fields[7]};
    for (size_t e = 0; e < errorNames().size(); ++e)
        if (!fields[kFixed + e].empty())
            score.errors[errorNames()[e]] = numberIn(fields[kFixed + e]);
    return score;
}

bool isFor(const Fields& fields, const std::string& source, const Contender& contender)
{
    return fields[0] == source && fields[2] == contender.label &&
           (fields[3] == "0") == contender.ours;
}

std::vector<Fields> rowsOf(const std::string& path)
{
    std::ifstream file(path);
    std::string line;
    if (!std::getline(file, line)) return {};  // nothing yet
    if (line + "\n" != header())
        throw Error(ErrorKind::input, path,
                    Found("other columns").expected("a table of bench-fit"));
    std::vector<Fields> rows;
    for (size_t number = 2; std::getline(file, line); ++number) {
        rows.push_back(csvFields(line));
        if (rows.back().size() != kFixed + errorNames().size())
            throw Error(ErrorKind::input, path + ":" + std::to_string(number),
                        fmt::format(Found("{} fields").expected("{}"), rows.back().size(),
                                    kFixed + errorNames().size()));
    }
    return rows;
}

}  // namespace

std::string benchCsv(const std::vector<MaterialScores>& materials,
                     const std::vector<Contender>& contenders)
{
    std::string text = header();
    for (const MaterialScores& material : materials) {
        if (!material.error.empty()) continue;
        for (const Contender& contender : contenders) {
            const Score* score = scoreOf(material, contender);
            text += csvLine(score ? fieldsOf(material, *score) : emptyFields(material, contender));
        }
    }
    return text;
}

std::vector<MaterialScores> scoresFromCsv(const std::string& path,
                                          const std::vector<Contender>& contenders)
{
    const std::vector<Fields> rows = rowsOf(path);
    std::vector<MaterialScores> materials;
    for (const Fields& first : rows) {
        const std::string& source = first[0];
        if (std::any_of(materials.begin(), materials.end(),
                        [&](const MaterialScores& m) { return m.source == source; }))
            continue;
        MaterialScores material{source, first[1], {}, {}};
        size_t known = 0;
        for (const Contender& contender : contenders) {
            const auto row = std::find_if(rows.begin(), rows.end(), [&](const Fields& fields) {
                return isFor(fields, source, contender);
            });
            if (row == rows.end()) break;
            ++known;
            if (!(*row)[4].empty()) material.scores.push_back(scoreFrom(contender, *row));
        }
        if (known == contenders.size()) materials.push_back(std::move(material));
    }
    return materials;
}

}  // namespace fbrdf::tool
