// NumberRows.h - the numbers of a line, and whether angles are radians or degrees.
#pragma once
#include "InputFile.h"
#include "SampleRow.h"
#include "Text.h"

namespace fbrdf {

/// Replaces `numbers` by those of the words. Throws Error(input) at the line for a word that is
/// none.
void parseNumbers(const InputFile& file, size_t line, const std::vector<std::string_view>& words,
                  std::vector<double>& numbers);

/// Rows of theta_i, phi_i, theta_o, phi_o of a file that does not name the unit. They are radians
/// unless a zenith angle is above pi, which no direction has in radians; then all are degrees. A
/// scan in degrees without one angle above 3.14 degrees does not exist.
class AngleRows {
public:
    void add(double theta_i, double phi_i, double theta_o, double phi_o, const Vec3d& f);
    bool inDegrees() const;
    void addTo(Source& source) const;

private:
    struct Row {
        double theta_i, phi_i, theta_o, phi_o;
        Vec3d f;
    };
    std::vector<Row> rows_;
    double largest_ = 0.0;  ///< zenith angle
};

}  // namespace fbrdf
