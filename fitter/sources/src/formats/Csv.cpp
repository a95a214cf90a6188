// Csv.cpp - the project's own text format for scattered samples: a header names the columns
// (Columns.h has their meaning), '#' starts a comment line. Fields are separated by commas, or as
// spreadsheets, R and pandas write them (NamedTable.h): semicolons, tabs, blanks, quotes, decimal
// commas, missing values.
#include "Columns.h"
#include "Formats.h"
#include "NamedTable.h"
#include "NumberRows.h"

namespace fbrdf {

bool isCsv(const InputFile& file)
{
    return looksLikeText(file.bytes()) && namesGeometry(columnNamesOf(file.bytes()));
}

Source readCsv(const FileRequest& request)
{
    NamedTable table(*request.file);
    const ColumnLayout layout = columnLayout(*request.file, table.line(), table.names());
    Source source;
    ColumnValues values;
    source.samples.reserve(mostRows(*request.file, layout.leastFields()));
    while (table.next()) {
        for (size_t i = 0; i < layout.fields.size(); ++i) {
            const ColumnLayout::Field field = layout.fields[i];
            if (field.used) values[field.column] = table.number(i) * field.unit;
        }
        addRow(rowOf(values, layout, request.options.cosine), source.samples, source.report);
    }
    source.description = describeColumns(layout, request.options.cosine);
    source.assumptions = assumptionsOf(layout);
    requireSamples(source, request.file->path());
    return source;
}

}  // namespace fbrdf
