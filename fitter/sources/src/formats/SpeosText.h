// SpeosText.h - the text files of Ansys Speos (OPTIS): what their two formats for surfaces share.
#pragma once
#include "InputFile.h"

#include <fbrdf/brdf/Conventions.h>

#include <string_view>
#include <vector>

namespace fbrdf {

/// Reads a file from left to right; numbers may stand anywhere across lines.
class SpeosText {
public:
    explicit SpeosText(const InputFile& file) : file_(file), rest_(file.bytes()) {}

    /// The rest of this line, without its end.
    std::string_view line();
    /// Skips as many characters, and the rest of their line.
    void skip(size_t characters);
    double number(const char* what);
    /// A whole number from `least` to `most`.
    size_t count(const char* what, size_t least, size_t most);
    /// `n` numbers. No memory is taken for more than the file can have.
    std::vector<double> numbers(size_t n, const char* what);
    /// Error(input) at the line reached.
    Error fail(const std::string& what) const;

private:
    const InputFile& file_;
    std::string_view rest_;
};

/// The nodes of a table over the hemisphere of scattered directions.
struct SpeosGrid {
    std::vector<double> theta, phi;  ///< degrees, ascending

    size_t nodes() const { return theta.size() * phi.size(); }
    bool operator==(const SpeosGrid& other) const
    {
        return theta == other.theta && phi == other.phi;
    }
    /// Integral of a table over the hemisphere, times the cosine or not; `values` are theta x phi,
    /// phi fastest. A table of azimuths up to 180 degrees stands for its mirror image as well.
    double integral(const float* values, bool cosine) const;
    /// 1 / number of times that the table gives the direction of a node: a pole is given for every
    /// azimuth, a seam twice.
    double weight(size_t t, size_t p) const;
};

/// What the head of both formats tells.
struct SpeosHead {
    bool reflection = false;
    bool times_cosine = false;  ///< values are proportional to f cos theta, else to f
};

/// Reads title, mode, comment and description.
void readSpeosTitle(SpeosText& text);
/// Reads the flags of sides and of the type of values. Throws Error(input) where there is no
/// reflection.
SpeosHead readSpeosFlags(SpeosText& text);
/// Reads a table and appends its values, theta x phi, phi fastest.
SpeosGrid readSpeosTable(SpeosText& text, std::vector<float>& values);

/// Direction of the light for an incidence in degrees; the mirror direction is at azimuth 0.
Vec3d speosLight(double incidence, double turn);

}  // namespace fbrdf
