#include "ShaderRewriter.h"

#include <glad/gl.h>

#include <cstring>
#include <utility>

namespace fbrdf::test {
namespace {

/// One for each backend: a function that GL calls has no user pointer.
template <Backend backend>
struct Rewriting {
    static inline PFNGLSHADERSOURCEPROC real = nullptr;
    static inline ShaderRewriter rewrite;

    static void GLAD_API_PTR shaderSource(GLuint shader, GLsizei count, const GLchar* const* parts,
                                          const GLint* lengths)
    {
        std::string text;
        for (GLsizei i = 0; i < count; ++i)
            text += lengths && lengths[i] >= 0
                        ? std::string(parts[i], static_cast<size_t>(lengths[i]))
                        : std::string(parts[i]);
        text = rewrite(std::move(text));
        const GLchar* const whole = text.c_str();
        real(shader, 1, &whole, nullptr);
    }

    static void* load(void* user, const char* name)
    {
        const auto loader =
            backend == Backend::egl ? HeadlessContext::loadEgl : HeadlessContext::loadOsMesa;
        void* const function = loader(user, name);
        if (std::strcmp(name, "glShaderSource") != 0) return function;
        real = reinterpret_cast<PFNGLSHADERSOURCEPROC>(function);
        return reinterpret_cast<void*>(shaderSource);
    }
};

template <Backend backend>
HeadlessContext::Load rewritingBy(ShaderRewriter rewrite)
{
    Rewriting<backend>::rewrite = std::move(rewrite);
    return Rewriting<backend>::load;
}

}  // namespace

ShaderRewriter afterMain(const std::string& statements)
{
    return [statements](std::string text) {
        const std::string main = "void main()";
        const size_t at = text.rfind(main);
        if (text.find("fbrdfColour = ") == std::string::npos || at == std::string::npos)
            return text;
        text.replace(at, main.size(), "void fbrdfWholeMain()");
        return text + "void main()\n{\n    fbrdfWholeMain();\n" + statements + "}\n";
    };
}

HeadlessContext::Load rewritingShaders(Backend backend, ShaderRewriter rewrite)
{
    return backend == Backend::egl ? rewritingBy<Backend::egl>(std::move(rewrite))
                                   : rewritingBy<Backend::osmesa>(std::move(rewrite));
}

}  // namespace fbrdf::test
