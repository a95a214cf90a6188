#include "UploadGuard.h"

namespace fbrdf::gl {
namespace {

constexpr GLenum kUnpack[] = {GL_UNPACK_ALIGNMENT,   GL_UNPACK_ROW_LENGTH,  GL_UNPACK_SKIP_ROWS,
                              GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_IMAGES, GL_UNPACK_IMAGE_HEIGHT,
                              GL_UNPACK_SWAP_BYTES,  GL_UNPACK_LSB_FIRST};

struct Transfer {
    GLenum name;
    GLfloat neutral;
};
constexpr Transfer kTransfer[] = {
    {GL_RED_SCALE, 1.0f},  {GL_GREEN_SCALE, 1.0f}, {GL_BLUE_SCALE, 1.0f}, {GL_RED_BIAS, 0.0f},
    {GL_GREEN_BIAS, 0.0f}, {GL_BLUE_BIAS, 0.0f},   {GL_MAP_COLOR, 0.0f}};

GLuint unsignedOf(GLint value)
{
    return static_cast<GLuint>(value);
}

}  // namespace

UploadGuard::UploadGuard(const Device& device)
    : gl_(device.gl),
      fixedFunction_(!device.capabilities.coreProfile),
      vertexArrays_(device.capabilities.vertexArrays),
      framebuffers_(device.capabilities.framebufferObjects)
{
    for (const GLenum name : kUnpack) {
        unpack_.push_back(integer(gl_, name));
        gl_.PixelStorei(name, name == GL_UNPACK_ALIGNMENT ? 1 : 0);
    }
    if (fixedFunction_ && gl_.PixelTransferf)
        for (const Transfer& t : kTransfer) {
            GLfloat value = 0.0f;
            gl_.GetFloatv(t.name, &value);
            transfer_.push_back(value);
            gl_.PixelTransferf(t.name, t.neutral);
        }
    unpackBuffer_ = integer(gl_, GL_PIXEL_UNPACK_BUFFER_BINDING);
    gl_.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    texture2d_ = integer(gl_, GL_TEXTURE_BINDING_2D);
    texture3d_ = integer(gl_, GL_TEXTURE_BINDING_3D);
    arrayBuffer_ = integer(gl_, GL_ARRAY_BUFFER_BINDING);
    if (vertexArrays_)
        vertexArray_ = integer(gl_, GL_VERTEX_ARRAY_BINDING);
    else
        elementBuffer_ = integer(gl_, GL_ELEMENT_ARRAY_BUFFER_BINDING);
    if (framebuffers_) {
        framebuffer_ = integer(gl_, GL_DRAW_FRAMEBUFFER_BINDING);
        renderbuffer_ = integer(gl_, GL_RENDERBUFFER_BINDING);
    }
}

UploadGuard::~UploadGuard()
{
    for (size_t i = 0; i < unpack_.size(); ++i) gl_.PixelStorei(kUnpack[i], unpack_[i]);
    for (size_t i = 0; i < transfer_.size(); ++i)
        gl_.PixelTransferf(kTransfer[i].name, transfer_[i]);
    gl_.BindBuffer(GL_PIXEL_UNPACK_BUFFER, unsignedOf(unpackBuffer_));
    gl_.BindTexture(GL_TEXTURE_2D, unsignedOf(texture2d_));
    gl_.BindTexture(GL_TEXTURE_3D, unsignedOf(texture3d_));
    if (vertexArrays_)
        gl_.BindVertexArray(unsignedOf(vertexArray_));
    else
        gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, unsignedOf(elementBuffer_));
    gl_.BindBuffer(GL_ARRAY_BUFFER, unsignedOf(arrayBuffer_));
    if (framebuffers_) {
        gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, unsignedOf(framebuffer_));
        gl_.BindRenderbuffer(GL_RENDERBUFFER, unsignedOf(renderbuffer_));
    }
}

}  // namespace fbrdf::gl
