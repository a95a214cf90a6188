// GlslTokens.h - a GLSL text as a list of tokens.
#pragma once
#include <string>
#include <vector>

namespace fbrdf::bench {

/// Without comments and lines that begin with #.
std::vector<std::string> glslTokens(const std::string& text);

}  // namespace fbrdf::bench
