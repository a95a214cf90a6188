// EmbeddedShaders.h - the GLSL files of this library, compiled in by EmbedShaders.cmake.
#pragma once
#include <string_view>

namespace fbrdf {

/// Text of glsl/<name>; empty where there is no such file.
std::string_view osgFbrdfShader(std::string_view name);

}  // namespace fbrdf
