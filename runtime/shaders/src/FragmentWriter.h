// FragmentWriter.h - writes the uniforms and main() of a fragment shader from a form.
#pragma once
#include <fbrdf/shaders/ShaderSource.h>

#include <string>

namespace fbrdf {

struct FragmentContext {
    const Form& form;
    const std::vector<TableEncoding>& encodings;
    const ProgramSpec& spec;
};

std::string uniformDeclarations(const FragmentContext& context);
std::string mainFunction(const FragmentContext& context);

}  // namespace fbrdf
