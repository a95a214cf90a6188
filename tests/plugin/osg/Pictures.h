// Pictures.h - keeps what tests drew, to be looked at, where FBRDF_KEEP_SCREENS is in the
// environment.
#pragma once
#include <string>
#include <vector>

namespace fbrdf::test {

/// Writes the picture (RGBA, rows from the bottom, linear radiance) to NAME.png at that prefix, as
/// sRGB.
void keepPicture(const std::vector<float>& picture, int width, const std::string& name);

}  // namespace fbrdf::test
