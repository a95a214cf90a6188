// Columns.h - named columns of scattered samples: what the project's text and binary formats share.
// Directions are wo_x,wo_y,wo_z and wi_x,wi_y,wi_z (any length), or theta_i,phi_i,theta_o,phi_o in
// degrees, or in the unit that their names tell (ColumnName.h): zenith angle and azimuth of wi and
// wo, both away from the surface, in the frame of Conventions.h. Values are r,g,b or one `value`,
// in 1/sr; without the cosine, or times cos theta_o with SourceOptions::cosine. `weight` is
// optional; further columns are skipped unread.
#pragma once
#include "InputFile.h"
#include "SampleRow.h"

#include <array>

namespace fbrdf {

enum class Column {
    wo_x,
    wo_y,
    wo_z,
    wi_x,
    wi_y,
    wi_z,
    theta_i,
    phi_i,
    theta_o,
    phi_o,
    r,
    g,
    b,
    value,
    weight
};
constexpr size_t kColumnCount = 15;
const char* columnName(Column column);

/// The numbers of a row by Column; those that the file has not are as initialised.
class ColumnValues {
public:
    ColumnValues() { (*this)[Column::weight] = 1.0; }
    double& operator[](Column column) { return values_[static_cast<size_t>(column)]; }
    double operator[](Column column) const { return values_[static_cast<size_t>(column)]; }

private:
    std::array<double, kColumnCount> values_{};
};

/// What the fields of a row mean.
struct ColumnLayout {
    struct Field {
        bool used = false;
        Column column = Column::value;
        double unit = 1.0;  ///< degrees in the unit of an angle; 1 for all else
    };
    std::vector<Field> fields;
    bool directions = false;  ///< wo_x..wi_z, else angles
    bool colour = false;      ///< r,g,b, else value
    bool namesUnit = false;   ///< a unit stands in the name of an angle

    /// Fields of a usable row.
    size_t leastFields() const { return (directions ? 6 : 4) + (colour ? 3 : 1); }
};

/// True when the names of columns, in any case, include the directions or the angles of a pair.
bool namesGeometry(const std::vector<std::string>& names);
/// Throws Error(input) at the header's line unless it names a geometry and values, each once, and
/// angles in no other unit than degrees or radians.
ColumnLayout columnLayout(const InputFile& file, size_t line,
                          const std::vector<std::string>& names);
/// The samples' units that the names do not tell, for Source::assumptions.
std::vector<std::string> assumptionsOf(const ColumnLayout& layout);

SampleRow rowOf(const ColumnValues& values, const ColumnLayout& layout, bool cosine);
/// "scattered samples, linear RGB, 1/sr": for Source::description.
std::string describeColumns(const ColumnLayout& layout, bool cosine);

}  // namespace fbrdf
