// NumberRows.h - the numbers of a line, and whether angles are radians or degrees.
#pragma once
#include <fbrdf/base/Text.h>
#include <fbrdf/sources/Fields.h>
#include "InputFile.h"
#include "SampleRow.h"

#include <optional>

namespace fbrdf {

/// Replaces `words` by the fields of a line of numbers, by the rules of separatorOfNumbers.
void splitNumbers(std::string_view line, std::vector<std::string_view>& words);

/// Replaces `numbers` by those of the words; a missing value (Fields.h) becomes NaN. Throws
/// Error(input) at the line for a word that is neither.
void parseNumbers(const InputFile& file, size_t line, const std::vector<std::string_view>& words,
                  std::vector<double>& numbers);

/// The most rows that a text can have with one row a line, of `numbers` numbers at least; each
/// takes two bytes with its separator. Memory that is reserved for as many does not grow by
/// copying.
size_t mostRows(const InputFile& file, size_t numbers);

/// Rows of theta_i, phi_i, theta_o, phi_o of a file that does not name the unit. They are radians
/// unless a zenith angle is above pi, which no direction has in radians; then all are degrees. A
/// scan in degrees without one angle above 3.14 degrees does not exist.
class AngleRows {
public:
    /// `degrees` - in the unit of the angles, where the file names it.
    explicit AngleRows(std::optional<double> degrees = {}) : degrees_(degrees) {}

    void reserve(size_t rows) { rows_.reserve(rows); }
    void add(double theta_i, double phi_i, double theta_o, double phi_o, const Vec3d& f);
    bool inDegrees() const;
    /// "angles in degrees, by their size": for Source::assumptions.
    std::string assumption() const;
    void addTo(Source& source) const;

private:
    struct Row {
        double theta_i, phi_i, theta_o, phi_o;
        Vec3f f;
    };
    std::vector<Row> rows_;
    std::optional<double> degrees_;
    double largest_ = 0.0;  ///< zenith angle
};

}  // namespace fbrdf
