#include "StorageGuard.h"

namespace fbrdf::gl {

StorageGuard::StorageGuard(const Device& device, int bindings)
    : device_(device), gl_(device.gl), bindings_(static_cast<size_t>(bindings))
{
    if (device.state != StateMode::restore) return;
    general_ = integer(gl_, GL_SHADER_STORAGE_BUFFER_BINDING);
    GLuint index = 0;
    for (Binding& binding : bindings_) {
        gl_.GetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, index, &binding.buffer);
        gl_.GetInteger64i_v(GL_SHADER_STORAGE_BUFFER_START, index, &binding.start);
        gl_.GetInteger64i_v(GL_SHADER_STORAGE_BUFFER_SIZE, index, &binding.size);
        ++index;
    }
}

StorageGuard::~StorageGuard()
{
    if (device_.state == StateMode::leave) return;
    GLuint index = 0;
    for (const Binding& binding : bindings_) {
        // A size of 0 is what was bound without a range, which GL takes for all of the buffer.
        if (binding.buffer == 0 || binding.size == 0)
            gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, index, unsignedOf(binding.buffer));
        else
            gl_.BindBufferRange(GL_SHADER_STORAGE_BUFFER, index, unsignedOf(binding.buffer),
                                static_cast<GLintptr>(binding.start),
                                static_cast<GLsizeiptr>(binding.size));
        ++index;
    }
    // Last, as the others change it too.
    gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, unsignedOf(general_));
}

}  // namespace fbrdf::gl
