// BinaryColumns.cpp - the project's own binary format for tens of millions of scattered samples.
// Three lines of text, then float32 numbers, little endian, row after row:
//   fbrdf-columns 1
//   wo_x,wo_y,wo_z,wi_x,wi_y,wi_z,r,g,b
//   1000000
//   <1000000 x 9 float32>
// The second line names the columns as the header of a CSV file does (Columns.h has their meaning),
// the third is the number of rows. In numpy: file.write(b"fbrdf-columns 1\\nwo_x,...\\n%d\\n" % n),
// then rows.astype("<f4").tofile(file). Usual extension: .f32c.
//
// The file is mapped and read block by block, in memory that does not depend on the number of rows.
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Text.h>
#include "Columns.h"
#include "Formats.h"

#include <cstring>

namespace fbrdf {
namespace {

constexpr std::string_view kColumnsMagic = "fbrdf-columns 1\n";
/// The longest head that is searched for its line ends: 3 lines, far below a million.
constexpr size_t kLongestHead = 1 << 16;

struct BinaryTable {
    std::shared_ptr<const InputFile> file;
    ColumnLayout layout;
    bool cosine = false;
    uint64_t rows = 0;
    size_t start = 0;  ///< byte of the first row

    size_t rowBytes() const { return layout.fields.size() * sizeof(float); }
};

/// Byte after the third line's end.
size_t headSize(const InputFile& file)
{
    size_t end = 0;
    for (int line = 1; line <= 3; ++line) {
        const size_t newline = file.bytes().substr(0, kLongestHead).find('\n', end);
        if (newline == std::string_view::npos)
            throw lineError(file, size_t(line),
                            Found("no end of the line").expected("three lines"));
        end = newline + 1;
    }
    return end;
}

void readHead(BinaryTable& table)
{
    const InputFile& file = *table.file;
    if (!isBinaryColumns(file))
        throw lineError(file, 1, Found("no 'fbrdf-columns 1'").expected("it"));
    table.start = headSize(file);
    LineReader lines(file.bytes().substr(0, table.start));
    std::string_view line;
    lines.next(line);
    lines.next(line);
    std::vector<std::string_view> fields;
    splitFields(line, ',', fields);
    table.layout = columnLayout(file, 2, {fields.begin(), fields.end()});
    lines.next(line);
    long long rows = 0;
    if (!parseInteger(trimmed(line), rows) || rows < 1)
        throw lineError(file, 3, Found(inQuotes(line)).expected("a number of rows"));
    table.rows = static_cast<uint64_t>(rows);
}

void requireSize(const BinaryTable& table)
{
    const uint64_t held = table.file->size() - table.start;
    if (held % table.rowBytes() == 0 && held / table.rowBytes() == table.rows) return;
    throw inputError(*table.file, table.start,
                     Found(std::to_string(held) + " bytes of data")
                         .expected(std::to_string(table.rows) + " rows of " +
                                   std::to_string(table.rowBytes()) + " bytes"));
}

void readRows(const BinaryTable& table, uint64_t first, size_t count, std::vector<Sample>& samples,
              SampleReport& report)
{
    const size_t begin = table.start + size_t(first) * table.rowBytes();
    const char* at = table.file->bytes().data() + begin;
    ColumnValues values;
    for (size_t row = 0; row < count; ++row) {
        for (const ColumnLayout::Field field : table.layout.fields) {
            float value;
            std::memcpy(&value, at, sizeof value);
            at += sizeof value;
            if (field.used) values[field.column] = static_cast<double>(value) * field.unit;
        }
        addRow(rowOf(values, table.layout, table.cosine), samples, report);
    }
    table.file->release(begin, count * table.rowBytes());
}

}  // namespace

bool isBinaryColumns(const InputFile& file)
{
    return file.bytes().substr(0, kColumnsMagic.size()) == kColumnsMagic;
}

Source readBinaryColumns(const FileRequest& request)
{
    auto table = std::make_shared<BinaryTable>();
    table->file = request.file;
    table->cosine = request.options.cosine;
    readHead(*table);
    requireSize(*table);
    Source source;
    source.description = describeColumns(table->layout, table->cosine);
    source.assumptions = assumptionsOf(table->layout);
    source.stream.rows = table->rows;
    source.stream.read = [table](uint64_t first, size_t count, std::vector<Sample>& samples,
                                 SampleReport& report) {
        readRows(*table, first, count, samples, report);
    };
    return source;
}

}  // namespace fbrdf
