// GlslTokens.h - a GLSL text as a list of tokens.
#pragma once
#include <string>
#include <vector>

namespace fbrdf::bench {

/// Without comments and lines that begin with #.
std::vector<std::string> glslTokens(const std::string& text);

/// What a literal is worth, whatever the locale; a suffix does not count. 0 for other tokens.
double glslNumber(const std::string& token);

}  // namespace fbrdf::bench
