// Wavelengths.h - the wavelengths of a file, in nanometres, and the colour that its bands become.
#pragma once
#include "Formats.h"

#include <optional>
#include <string>
#include <vector>

namespace fbrdf {

/// Nanometres in the unit of wavelengths for which a file names none, by their size: nm where all
/// are at least 100, um where all are from 0.1 to below 100, m where all are below 1e-4. Nothing
/// where they are in none of these ranges together, or there are none.
std::optional<double> nanometresInUnitOf(const std::vector<double>& wavelengths);
/// "nm", "um" or "m" of what the function above returns.
const char* nameOfWavelengthUnit(double nanometres);

/// Wavelength of a column named "532nm" or "0.532 um", in nm; 0 for any other name.
double wavelengthNamed(const std::string& name);

/// Turns the bands of one file into a colour: all of them into linear sRGB (Spectrum.h), or the one
/// that FILE@WAVELENGTH chooses into grey.
class BandColour {
public:
    /// `wavelengths` - n, in the unit that their size names, in any order, for values in the same
    /// order. Throws Error(input) where no unit fits, where two are equal, and where there are
    /// several of which none is visible and none is chosen; Error(usage) for a choice that is not
    /// among them.
    BandColour(const FileRequest& request, const std::vector<double>& wavelengths);

    /// `values` - one for each wavelength.
    Vec3d operator()(const double* values) const;
    /// Number of wavelengths of the file.
    size_t bands() const { return order_.size(); }
    /// Index of the value that is taken, where one is.
    size_t chosen() const { return chosen_; }
    /// True where a colour may lie outside the gamut.
    bool isSpectral() const { return !weights_.empty(); }
    /// "31 wavelengths from 400 to 700 nm to linear sRGB (D65, CIE 1931)" or "one band, 550 nm".
    std::string description() const;
    /// What was assumed about them, for Source::assumptions.
    std::vector<std::string> assumptions() const;

private:
    void choose(const FileRequest& request);
    std::string listed() const;

    double unit_ = 1.0;
    std::vector<size_t> order_;        ///< indices of the values by ascending wavelength
    std::vector<double> wavelengths_;  ///< nm, ascending
    std::vector<Vec3d> weights_;       ///< of the values; empty where one of them is chosen
    size_t chosen_ = 0;  ///< index of the value that is taken where there are no weights
};

}  // namespace fbrdf
