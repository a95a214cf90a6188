// EmbeddedShaders.h - the files of glsl/, by name.
#pragma once
#include <string_view>

namespace fbrdf {

std::string_view vtkFbrdfShader(std::string_view name);

}  // namespace fbrdf
