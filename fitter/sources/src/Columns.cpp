#include "Columns.h"

#include "Text.h"

#include <algorithm>

namespace fbrdf {
namespace {

constexpr std::array<const char*, kColumnCount> kNames = {
    "wo_x",    "wo_y",  "wo_z", "wi_x", "wi_y", "wi_z",  "theta_i", "phi_i",
    "theta_o", "phi_o", "r",    "g",    "b",    "value", "weight"};

using Field = ColumnLayout::Field;

std::vector<Field> fieldsOf(std::string_view header)
{
    std::vector<std::string_view> names;
    splitFields(header, ',', names);
    std::vector<Field> fields;
    for (const std::string_view name : names) {
        const auto found = std::find(kNames.begin(), kNames.end(), lowerCase(name));
        if (found == kNames.end())
            fields.push_back({});
        else
            fields.push_back({true, static_cast<Column>(found - kNames.begin())});
    }
    return fields;
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

}  // namespace

const char* columnName(Column column)
{
    return kNames[static_cast<size_t>(column)];
}

bool namesGeometry(std::string_view header)
{
    return hasGeometry(fieldsOf(header));
}

ColumnLayout columnLayout(const InputFile& file, size_t line, std::string_view header)
{
    ColumnLayout layout;
    std::vector<Field>& fields = layout.fields;
    fields = fieldsOf(header);
    const auto fail = [&](const std::string& what) {
        return lineError(file, line, "found " + what);
    };
    for (size_t i = 0; i < kColumnCount; ++i)
        if (countOf(fields, static_cast<Column>(i)) > 1)
            throw fail("column '" + std::string(kNames[i]) + "' twice, expected each name once");
    layout.directions = hasAll(fields, Column::wo_x, Column::wi_z);
    layout.colour = hasAll(fields, Column::r, Column::b);
    if (!hasGeometry(fields))
        throw fail("the header " + quoted(header) +
                   ", expected columns wo_x,wo_y,wo_z,wi_x,wi_y,wi_z or "
                   "theta_i,phi_i,theta_o,phi_o");
    if (!layout.colour && !hasAll(fields, Column::value, Column::value))
        throw fail("the header " + quoted(header) + ", expected columns r,g,b or value");
    if (layout.directions) forget(fields, Column::theta_i, Column::phi_o);
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

std::string describeColumns(const ColumnLayout& layout, bool cosine)
{
    return std::string("scattered samples, ") + (layout.colour ? "linear RGB" : "one channel") +
           ", 1/sr" + (cosine ? " (cos theta_o divided out)" : "");
}

}  // namespace fbrdf
