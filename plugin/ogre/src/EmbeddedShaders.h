// EmbeddedShaders.h - the texts of glsl/, embedded by the build.
#pragma once
#include <string_view>

namespace fbrdf {

/// The text of plugin/ogre/glsl/<name>, or "" when there is no such file.
std::string_view ogreFbrdfShader(std::string_view name);

}  // namespace fbrdf
