#include "Columns.h"

#include "ColumnName.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/base/Text.h>

#include <algorithm>
#include <optional>

namespace fbrdf {
namespace {

constexpr std::array<const char*, kColumnCount> kNames = {
    "wo_x",    "wo_y",  "wo_z", "wi_x", "wi_y", "wi_z",  "theta_i", "phi_i",
    "theta_o", "phi_o", "r",    "g",    "b",    "value", "weight"};

using Field = ColumnLayout::Field;

/// Nothing for a name that no column of ours has.
std::optional<Column> columnNamed(const std::string& name)
{
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) return {};
    return static_cast<Column>(found - kNames.begin());
}

bool isAngle(Column column)
{
    return column >= Column::theta_i && column <= Column::phi_o;
}

std::vector<Field> fieldsOf(const std::vector<std::string>& names)
{
    std::vector<Field> fields;
    for (const std::string& name : names) {
        const std::optional<Column> column = columnNamed(columnNameOf(name).base);
        fields.push_back(column ? Field{true, *column, 1.0} : Field{});
    }
    return fields;
}

std::string joined(const std::vector<std::string>& names)
{
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ",") + name;
    return text;
}

long countOf(const std::vector<Field>& fields, Column column)
{
    return std::count_if(fields.begin(), fields.end(),
                         [&](const Field& f) { return f.used && f.column == column; });
}

bool hasAll(const std::vector<Field>& fields, Column first, Column last)
{
    for (int c = static_cast<int>(first); c <= static_cast<int>(last); ++c)
        if (countOf(fields, static_cast<Column>(c)) == 0) return false;
    return true;
}

void forget(std::vector<Field>& fields, Column first, Column last)
{
    for (Field& field : fields)
        if (field.column >= first && field.column <= last) field.used = false;
}

bool hasGeometry(const std::vector<Field>& fields)
{
    return hasAll(fields, Column::wo_x, Column::wi_z) ||
           hasAll(fields, Column::theta_i, Column::phi_o);
}

/// Sets the units of angles from what stands in their names.
void readUnits(const InputFile& file, size_t line, const std::vector<std::string>& names,
               ColumnLayout& layout)
{
    for (size_t i = 0; i < names.size(); ++i) {
        Field& field = layout.fields[i];
        if (!field.used || !isAngle(field.column)) continue;
        const std::string unit = columnNameOf(names[i]).unit;
        const std::optional<double> degrees = degreesIn(unit);
        if (!degrees)
            throw lineError(file, line,
                            Found("the unit " + inQuotes(unit) + " of " + columnName(field.column))
                                .expected("deg or rad"));
        field.unit = *degrees;
        layout.namesUnit |= !unit.empty();
    }
}

}  // namespace

const char* columnName(Column column)
{
    return kNames[static_cast<size_t>(column)];
}

bool namesGeometry(const std::vector<std::string>& names)
{
    return hasGeometry(fieldsOf(names));
}

ColumnLayout columnLayout(const InputFile& file, size_t line, const std::vector<std::string>& names)
{
    ColumnLayout layout;
    std::vector<Field>& fields = layout.fields;
    fields = fieldsOf(names);
    const Found header("the header " + inQuotes(joined(names)));
    for (size_t i = 0; i < kColumnCount; ++i)
        if (countOf(fields, static_cast<Column>(i)) > 1)
            throw lineError(
                file, line,
                Found("column '" + std::string(kNames[i]) + "' twice").expected("each name once"));
    layout.directions = hasAll(fields, Column::wo_x, Column::wi_z);
    layout.colour = hasAll(fields, Column::r, Column::b);
    if (!hasGeometry(fields))
        throw lineError(file, line,
                        header.expected("columns wo_x,wo_y,wo_z,wi_x,wi_y,wi_z or "
                                        "theta_i,phi_i,theta_o,phi_o"));
    if (!layout.colour && !hasAll(fields, Column::value, Column::value))
        throw lineError(file, line, header.expected("columns r,g,b or value"));
    if (layout.directions) forget(fields, Column::theta_i, Column::phi_o);
    readUnits(file, line, names, layout);
    if (layout.colour) forget(fields, Column::value, Column::value);
    return layout;
}

SampleRow rowOf(const ColumnValues& v, const ColumnLayout& layout, bool cosine)
{
    SampleRow row;
    if (layout.directions) {
        row.wo = {v[Column::wo_x], v[Column::wo_y], v[Column::wo_z]};
        row.wi = {v[Column::wi_x], v[Column::wi_y], v[Column::wi_z]};
    } else {
        row.wo = directionFromDegrees(v[Column::theta_o], v[Column::phi_o]);
        row.wi = directionFromDegrees(v[Column::theta_i], v[Column::phi_i]);
    }
    row.f =
        layout.colour ? Vec3d(v[Column::r], v[Column::g], v[Column::b]) : Vec3d(v[Column::value]);
    row.weight = v[Column::weight];
    if (cosine) row.f *= glm::length(row.wo) / std::max(row.wo.z, kHorizonCosine);
    return row;
}

std::vector<std::string> assumptionsOf(const ColumnLayout& layout)
{
    std::vector<std::string> found;
    if (!layout.directions && !layout.namesUnit) found.emplace_back("angles in degrees");
    if (!layout.colour) found.emplace_back("one channel as grey");
    return found;
}

std::string describeColumns(const ColumnLayout& layout, bool cosine)
{
    return std::string("scattered samples, ") + (layout.colour ? "linear RGB" : "one channel") +
           ", 1/sr" + (cosine ? " (cos theta_o divided out)" : "");
}

}  // namespace fbrdf
