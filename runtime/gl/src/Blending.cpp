#include "Blending.h"

namespace fbrdf::gl {

void setBlend(const Functions& gl, Blend blend)
{
    if (gl.version >= 30)
        blend == Blend::replace ? gl.Disablei(GL_BLEND, 0) : gl.Enablei(GL_BLEND, 0);
    else
        blend == Blend::replace ? gl.Disable(GL_BLEND) : gl.Enable(GL_BLEND);
    if (blend == Blend::replace) return;
    // (GL_DST_COLOR, GL_ZERO) is Blend::multiply, source x target. (0, 1) keeps alpha in both.
    const GLenum source = blend == Blend::add ? GL_ONE : GL_DST_COLOR,
                 target = blend == Blend::add ? GL_ONE : GL_ZERO;
    if (gl.version >= 40) {
        gl.BlendFuncSeparatei(0, source, target, GL_ZERO, GL_ONE);
        gl.BlendEquationSeparatei(0, GL_FUNC_ADD, GL_FUNC_ADD);
    } else {
        gl.BlendFuncSeparate(source, target, GL_ZERO, GL_ONE);
        gl.BlendEquationSeparate(GL_FUNC_ADD, GL_FUNC_ADD);
    }
}

}  // namespace fbrdf::gl
