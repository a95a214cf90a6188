// LightPicture.h - a picture of radiance as it comes row by row: made smaller and repaired on the
// way.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <cstdint>
#include <string>
#include <vector>

namespace fbrdf {

struct LightPicture {
    int width = 0, height = 0;
    std::vector<Vec3f> texels;  ///< rows from the top, finite and at least 0
    std::string notes;          ///< what was changed, each with a "; " before it
};

/// Makes a LightPicture of rows.
class LightRows {
public:
    /// Throws Error(input) naming `where` for sides of no LightLayout (CubeLayout.h), and those
    /// that cannot be averaged to 2^24 pixels or fewer.
    LightRows(int width, int height, const std::string& where);

    int width() const { return width_; }
    int height() const { return height_; }
    /// The next row from the top. Memory grows with the rows that were added, not with what a
    /// header promised.
    void add(const std::vector<Vec3f>& row);
    /// Moves out what was made. Expects that all rows were added.
    LightPicture picture();

private:
    Vec3f repaired(const Vec3f& value, Vec3f& before);

    int width_, height_, factor_ = 1, rows_ = 0;
    std::vector<Vec3d> sums_;  ///< of up to factor_ rows
    std::vector<Vec3f> texels_;
    int64_t negative_ = 0, infinite_ = 0, missing_ = 0;
};

/// Bytes of a Radiance picture (Radiance file formats, Ward 1997: flat, old and new run lengths).
/// What EXPOSURE says was multiplied in is divided out. Throws Error(input) naming `where`.
LightPicture decodeRadianceHdr(const std::string& bytes, const std::string& where);

/// Bytes of another format, by its name in OpenImageIO, through the module.
LightPicture decodeLightPicture(const std::string& bytes, const char* format,
                                const std::string& where);

}  // namespace fbrdf
