// Pictures.h - what tests drew, kept to be looked at: with FBRDF_KEEP_SCREENS in the environment.
#pragma once
#include <string>
#include <vector>

namespace fbrdf::test {

/// RGBA, rows from the bottom, linear radiance: to NAME.png at that prefix, as sRGB.
void keepPicture(const std::vector<float>& picture, int width, const std::string& name);

}  // namespace fbrdf::test
