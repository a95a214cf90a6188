#include "TextTable.h"

#include <fmt/format.h>

#include <algorithm>

namespace fbrdf::tool {
namespace {

// Characters of UTF-8 text: every byte but the continuation bytes 10xxxxxx.
size_t lengthOf(const std::string& text)
{
    return static_cast<size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
    }));
}

std::vector<size_t> widthsOf(size_t columns, const std::vector<std::vector<std::string>>& rows)
{
    std::vector<size_t> widths(columns, 0);
    for (const auto& row : rows)
        for (size_t c = 0; c < std::min(columns, row.size()); ++c)
            widths[c] = std::max(widths[c], lengthOf(row[c]));
    return widths;
}

std::string padded(const std::string& cell, size_t width, Align align, bool last)
{
    const std::string space(width - std::min(width, lengthOf(cell)), ' ');
    if (align == Align::right) return space + cell;
    return last ? cell : cell + space;
}

}  // namespace

std::string alignedTable(const std::vector<Align>& columns,
                         const std::vector<std::vector<std::string>>& rows, int indent)
{
    const std::vector<size_t> widths = widthsOf(columns.size(), rows);
    std::string text;
    for (const auto& row : rows) {
        text.append(static_cast<size_t>(indent), ' ');
        for (size_t c = 0; c < std::min(columns.size(), row.size()); ++c)
            text +=
                (c > 0 ? "  " : "") + padded(row[c], widths[c], columns[c], c + 1 == row.size());
        text.erase(text.find_last_not_of(' ') + 1);
        text += '\n';
    }
    return text;
}

std::string wrapped(const std::string& text, int indent, int width)
{
    const std::string margin(static_cast<size_t>(indent), ' ');
    std::string all, line;
    size_t begin = 0;
    while (begin < text.size()) {
        const size_t end = std::min(text.find(' ', begin), text.size());
        const std::string word = text.substr(begin, end - begin);
        const size_t length = margin.size() + lengthOf(line) + 1 + lengthOf(word);
        if (!line.empty() && length > static_cast<size_t>(width)) {
            all += margin + line + "\n";
            line.clear();
        }
        line += (line.empty() ? "" : " ") + word;
        begin = end + 1;
    }
    return all + margin + line + "\n";
}

std::string withSeparators(unsigned long long number)
{
    std::string digits = fmt::format("{}", number);
    for (size_t at = digits.size(); at > 3;) digits.insert(at -= 3, ",");
    return digits;
}

}  // namespace fbrdf::tool
