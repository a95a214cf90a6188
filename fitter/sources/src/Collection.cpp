#include "Collection.h"

#include <fbrdf/base/Text.h>

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <algorithm>
#include <filesystem>

namespace fbrdf {
namespace {

struct Entry {
    std::string set, name;
};

/// One entry a row; none when there is no materials.txt.
std::vector<Entry> entriesBeside(const InputFile& file)
{
    const std::string path = file.folder() + "/materials.txt";
    std::vector<Entry> entries;
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored) ||
        std::filesystem::file_size(path, ignored) == 0)
        return entries;
    const InputFile list(path);
    LineReader lines(list.bytes());
    std::vector<std::string_view> words;
    for (std::string_view line; lines.next(line);) {
        splitWords(line, words);
        if (words.empty()) continue;
        const std::string set(words.size() > 1 ? words.front() : std::string_view());
        entries.push_back({set, std::string(words.back())});
    }
    return entries;
}

Error choiceError(const FileRequest& request, const std::string& what)
{
    return Error(ErrorKind::usage, request.file->path(), what);
}

bool matches(const Entry& entry, const std::string& choice)
{
    return choice == entry.name || (!entry.set.empty() && choice == entry.set + "/" + entry.name);
}

size_t rowNamed(const FileRequest& request, const std::vector<Entry>& entries)
{
    size_t row = entries.size();
    for (size_t i = 0; i < entries.size(); ++i) {
        if (!matches(entries[i], request.choice)) continue;
        if (row != entries.size())
            throw choiceError(request, Found(inQuotes(request.choice) + " in several sets (" +
                                             entries[row].set + ", " + entries[i].set + ")")
                                           .expected("set/name"));
        row = i;
    }
    if (row == entries.size())
        throw choiceError(request, Found("no material " + inQuotes(request.choice))
                                       .expected("a name of the materials.txt beside it or a row"));
    return row;
}

std::string choiceFor(const std::vector<Entry>& entries, size_t row)
{
    const Entry& entry = entries[row];
    const auto sameName = std::count_if(entries.begin(), entries.end(), [&](const Entry& other) {
        return other.name == entry.name;
    });
    return sameName == 1 ? entry.name : entry.set + "/" + entry.name;
}

}  // namespace

Chosen chosenMaterial(const FileRequest& request, size_t rows)
{
    const std::vector<Entry> entries = entriesBeside(*request.file);
    const std::string range = "a row from 0 to " + std::to_string(rows - 1);
    if (request.choice.empty() && rows > 1)
        throw choiceError(
            request, Found("no choice of material").expected("FILE#name or FILE#row, " + range));
    long long number = 0;
    if (!request.choice.empty() && !parseInteger(request.choice, number))
        number = static_cast<long long>(rowNamed(request, entries));
    if (number < 0 || static_cast<unsigned long long>(number) >= rows)
        throw choiceError(request, Found("row " + std::to_string(number)).expected(range));
    const size_t row = static_cast<size_t>(number);
    if (row < entries.size()) return {row, entries[row].name};
    return {row, request.file->stem() + "#" + std::to_string(row)};
}

std::vector<std::string> choicesOf(const FileRequest& request, size_t rows)
{
    const std::vector<Entry> entries = entriesBeside(*request.file);
    std::vector<std::string> choices;
    for (size_t row = 0; row < rows; ++row) {
        const bool named = row < entries.size();
        if (request.choice.empty() || (named && entries[row].set == request.choice))
            choices.push_back(named ? choiceFor(entries, row) : std::to_string(row));
    }
    return choices;
}

}  // namespace fbrdf
