#include "UploadGuard.h"

namespace fbrdf::gl {
namespace {

// In the order in which versions have introduced them: unpackStates() returns how many exist.
constexpr GLenum kUnpack[] = {GL_UNPACK_ALIGNMENT,   GL_UNPACK_ROW_LENGTH,  GL_UNPACK_SKIP_ROWS,
                              GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_IMAGES, GL_UNPACK_IMAGE_HEIGHT,
                              GL_UNPACK_SWAP_BYTES,  GL_UNPACK_LSB_FIRST};

constexpr size_t kUnpackCount = sizeof kUnpack / sizeof *kUnpack;
static_assert(kUnpackCount == UploadGuard::kUnpackStates);

// Scales, biases and maps of the fixed function apply to uploads in compatibility contexts.
struct Transfer {
    GLenum name;
    GLfloat neutral;
};
constexpr Transfer kTransfer[] = {
    {GL_RED_SCALE, 1.0f},  {GL_GREEN_SCALE, 1.0f}, {GL_BLUE_SCALE, 1.0f}, {GL_RED_BIAS, 0.0f},
    {GL_GREEN_BIAS, 0.0f}, {GL_BLUE_BIAS, 0.0f},   {GL_MAP_COLOR, 0.0f}};

}  // namespace

UploadGuard::UploadGuard(const Device& device) : device_(device), gl_(device.gl)
{
    if (device.state == StateMode::restore) save();
    // Images are packed tightly; GL's default alignment would skip bytes of RGB rows.
    for (size_t i = 0; i < unpackStates(); ++i)
        gl_.PixelStorei(kUnpack[i], kUnpack[i] == GL_UNPACK_ALIGNMENT ? 1 : 0);
    setTransfer();
    // With an unpack buffer bound, pointers would be taken for offsets into it.
    if (gl_.hasUnpackBuffer()) gl_.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
}

UploadGuard::~UploadGuard()
{
    // The vertex array first, in every mode: a later binding of an index buffer would change ours.
    if (device_.capabilities.vertexArrays) gl_.BindVertexArray(unsignedOf(vertexArray_));
    if (device_.state == StateMode::leave) return;
    for (size_t i = 0; i < unpackStates(); ++i) gl_.PixelStorei(kUnpack[i], unpack_[i]);
    for (size_t i = 0; i < transfer_.size(); ++i)
        gl_.PixelTransferf(kTransfer[i].name, transfer_[i]);
    if (gl_.hasUnpackBuffer()) gl_.BindBuffer(GL_PIXEL_UNPACK_BUFFER, unsignedOf(unpackBuffer_));
    gl_.BindTexture(GL_TEXTURE_2D, unsignedOf(texture2d_));
    gl_.BindTexture(GL_TEXTURE_CUBE_MAP, unsignedOf(textureCube_));
    if (gl_.hasVolumes()) gl_.BindTexture(GL_TEXTURE_3D, unsignedOf(texture3d_));
    if (gl_.hasArrays()) gl_.BindTexture(GL_TEXTURE_2D_ARRAY, unsignedOf(textureArray_));
    if (gl_.version >= 31) gl_.BindTexture(GL_TEXTURE_BUFFER, unsignedOf(textureBuffer_));
    if (!device_.capabilities.vertexArrays)
        gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, unsignedOf(elementBuffer_));
    gl_.BindBuffer(GL_ARRAY_BUFFER, unsignedOf(arrayBuffer_));
    if (device_.capabilities.framebufferObjects) {
        gl_.BindFramebuffer(gl_.drawFramebuffer(), unsignedOf(framebuffer_));
        gl_.BindRenderbuffer(GL_RENDERBUFFER, unsignedOf(renderbuffer_));
    }
}

/// ES 2.0 has the alignment, 3.0 all but the order of bytes and bits.
size_t UploadGuard::unpackStates() const
{
    if (!gl_.es) return kUnpackCount;
    return gl_.es < 30 ? 1 : 6;
}

bool UploadGuard::hasTransfer() const
{
    return !device_.capabilities.coreProfile && gl_.PixelTransferf;
}

void UploadGuard::setTransfer() const
{
    if (!hasTransfer()) return;
    for (const Transfer& t : kTransfer) gl_.PixelTransferf(t.name, t.neutral);
}

void UploadGuard::save()
{
    for (size_t i = 0; i < unpackStates(); ++i) unpack_[i] = integer(gl_, kUnpack[i]);
    if (hasTransfer())
        for (const Transfer& t : kTransfer) {
            transfer_.push_back(0.0f);
            gl_.GetFloatv(t.name, &transfer_.back());
        }
    if (gl_.hasUnpackBuffer()) unpackBuffer_ = integer(gl_, GL_PIXEL_UNPACK_BUFFER_BINDING);
    texture2d_ = integer(gl_, GL_TEXTURE_BINDING_2D);
    textureCube_ = integer(gl_, GL_TEXTURE_BINDING_CUBE_MAP);
    if (gl_.hasVolumes()) texture3d_ = integer(gl_, GL_TEXTURE_BINDING_3D);
    if (gl_.hasArrays()) textureArray_ = integer(gl_, GL_TEXTURE_BINDING_2D_ARRAY);
    if (gl_.version >= 31) textureBuffer_ = integer(gl_, GL_TEXTURE_BINDING_BUFFER);
    arrayBuffer_ = integer(gl_, GL_ARRAY_BUFFER_BINDING);
    if (device_.capabilities.vertexArrays)
        vertexArray_ = integer(gl_, GL_VERTEX_ARRAY_BINDING);
    else
        elementBuffer_ = integer(gl_, GL_ELEMENT_ARRAY_BUFFER_BINDING);
    if (device_.capabilities.framebufferObjects) {
        framebuffer_ = integer(gl_, GL_DRAW_FRAMEBUFFER_BINDING);
        renderbuffer_ = integer(gl_, GL_RENDERBUFFER_BINDING);
    }
}

}  // namespace fbrdf::gl
