// Sky.h - environments without a file.
#pragma once
#include <fbrdf/environment/Panorama.h>

#include <string>

namespace fbrdf {

/// "studio": soft boxes in a grey room. "overcast": Moon and Spencer 1942, the CIE standard
/// overcast sky, over ground. "clear": Preetham, Shirley, Smits 1999, with the sun, over ground.
std::vector<std::string> proceduralEnvironments();
/// True for one of these names.
bool isProceduralEnvironment(const std::string& name);
/// width x width / 2 texels, width a multiple of 4; the luminance of the irradiance of a surface
/// that faces up is pi, so that a white one is 1. The same each time. Throws Error(usage) that
/// lists the names, or for a width.
Panorama proceduralEnvironment(const std::string& name, int width = 1024);

}  // namespace fbrdf
