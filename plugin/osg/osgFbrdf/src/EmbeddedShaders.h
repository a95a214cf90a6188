// EmbeddedShaders.h - the GLSL files of this library, which EmbedShaders.cmake compiles in.
#pragma once
#include <string_view>

namespace fbrdf {

/// The text of glsl/<name>; empty where there is no such file.
std::string_view osgFbrdfShader(std::string_view name);

}  // namespace fbrdf
