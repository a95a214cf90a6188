// ShaderRewriter.h - a loader in whose contexts the text of every shader is changed before it is
// compiled, to play drivers that compute something else.
#pragma once
#include <fbrdf/headless/Context.h>

#include <functional>
#include <string>

namespace fbrdf::test {

using ShaderRewriter = std::function<std::string(std::string)>;

/// Appends `statements` to the main of each program that draws a pass, which may change what is
/// stored, fbrdfColour.
ShaderRewriter afterMain(const std::string& statements);

/// A later call for the same backend changes what is done in all contexts.
HeadlessContext::Load rewritingShaders(Backend backend, ShaderRewriter rewrite);

}  // namespace fbrdf::test
