// Csv.cpp - the project's own text format for scattered samples: a header names the columns
// (Columns.h has their meaning), '#' starts a comment line, fields are separated by commas.
#include "Columns.h"
#include "Formats.h"
#include "Text.h"

namespace fbrdf {
namespace {

/// Fills `values` from one line, walking it once.
void parseRow(const InputFile& file, size_t number, std::string_view line,
              const ColumnLayout& layout, ColumnValues& values)
{
    const size_t count = layout.fields.size();
    for (size_t i = 0; i < count; ++i) {
        const ColumnLayout::Field field = layout.fields[i];
        const size_t comma = line.find(',');
        const bool last = i + 1 == count;
        if (last != (comma == std::string_view::npos))
            throw lineError(file, number,
                            std::string(last ? "found more" : "found fewer") +
                                " fields, expected " + std::to_string(count) + " as in the header");
        const std::string_view text = trimmed(line.substr(0, comma));
        if (field.used && !parseNumber(text, values[field.column]))
            throw lineError(file, number,
                            "found " + quoted(text) + " as " + columnName(field.column) +
                                ", expected a number");
        if (!last) line.remove_prefix(comma + 1);
    }
}

}  // namespace

bool isCsv(const InputFile& file)
{
    if (!looksLikeText(file.bytes())) return false;
    LineReader lines(file.bytes());
    std::string_view header;
    return lines.nextData(header) && namesGeometry(header);
}

Source readCsv(const FileRequest& request)
{
    const InputFile& file = *request.file;
    LineReader lines(file.bytes());
    std::string_view line;
    if (!lines.nextData(line)) throw inputError(file, "found no line of data, expected a header");
    const ColumnLayout layout = columnLayout(file, lines.number(), line);
    Source source;
    ColumnValues values;
    while (lines.nextData(line)) {
        parseRow(file, lines.number(), line, layout, values);
        addRow(rowOf(values, layout, request.options.cosine), source.samples, source.report);
    }
    source.description = describeColumns(layout, request.options.cosine);
    requireSamples(source, file.path());
    return source;
}

}  // namespace fbrdf
