#include "ExrPixels.h"

#include <fbrdf/base/Error.h>

#include <OpenEXR/openexr.h>
#include <cstdint>
#include <cstring>

namespace fbrdf {
namespace {

int64_t onSize(exr_const_context_t, void* user)
{
    return static_cast<int64_t>(static_cast<const std::string*>(user)->size());
}

int64_t onRead(exr_const_context_t, void* user, void* buffer, uint64_t count, uint64_t offset,
               exr_stream_error_func_ptr_t)
{
    const std::string& bytes = *static_cast<const std::string*>(user);
    if (offset >= bytes.size()) return 0;
    const uint64_t given = std::min(count, uint64_t(bytes.size()) - offset);
    std::memcpy(buffer, bytes.data() + offset, static_cast<size_t>(given));
    return static_cast<int64_t>(given);
}

// Without a handler OpenEXR would print. It calls this with its context locked, so the context
// cannot be asked whose it is.
void ignoreMessage(exr_const_context_t, exr_result_t, const char*) {}

/// Where a channel stands in a pixel: Y alone, or R, G, B.
size_t channelIndex(const char* name)
{
    return *name == 'G' ? 1 : *name == 'B' ? 2 : 0;
}

}  // namespace

struct ExrPixels::Decoder {
    exr_context_t context = nullptr;

    Decoder() = default;
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;
    ~Decoder()
    {
        if (context) exr_finish(&context);
    }

    static void check(exr_result_t result, const std::string& where)
    {
        if (result == EXR_ERR_SUCCESS) return;
        throw Error(ErrorKind::input, where,
                    std::string("found what OpenEXR cannot read: ") +
                        exr_get_default_error_message(result));
    }

    void readLines(int index, int y, const ExrPart& part, float* pixels, const std::string& where)
    {
        exr_chunk_info_t chunk{};
        exr_decode_pipeline_t pipeline{};  // all zeros, as EXR_DECODE_PIPELINE_INITIALIZER
        check(exr_read_scanline_chunk_info(context, index, y, &chunk), where);
        exr_result_t result = exr_decoding_initialize(context, index, &chunk, &pipeline);
        if (result == EXR_ERR_SUCCESS) {
            decodeTo(pixels, part, pipeline);
            result = exr_decoding_choose_default_routines(context, index, &pipeline);
        }
        if (result == EXR_ERR_SUCCESS) result = exr_decoding_run(context, index, &pipeline);
        // The pipeline owns buffers, so it goes before check() may throw.
        exr_decoding_destroy(context, &pipeline);
        check(result, where);
    }

    static void decodeTo(float* pixels, const ExrPart& part, exr_decode_pipeline_t& pipeline)
    {
        // Channels are stored as planes of a line, by name: B, G, R. They are asked for as floats
        // that lie pixel by pixel, and the library turns halves into floats on the way.
        const int pixelBytes = part.channels * static_cast<int>(sizeof(float));
        for (int c = 0; c < pipeline.channel_count; ++c) {
            exr_coding_channel_info_t& channel = pipeline.channels[c];
            channel.user_data_type = EXR_PIXEL_FLOAT;
            channel.user_bytes_per_element = sizeof(float);
            channel.user_pixel_stride = pixelBytes;
            channel.user_line_stride = pixelBytes * part.width;
            channel.decode_to_ptr =
                reinterpret_cast<uint8_t*>(pixels + channelIndex(channel.channel_name));
        }
    }
};

ExrPixels::ExrPixels(const std::string& bytes, const std::string& where)
    : decoder_(std::make_unique<Decoder>())
{
    exr_context_initializer_t options = EXR_DEFAULT_CONTEXT_INITIALIZER;
    options.error_handler_fn = ignoreMessage;
    options.user_data = const_cast<std::string*>(&bytes);
    options.read_fn = onRead;
    options.size_fn = onSize;
    // Otherwise the library would search a file whose table of offsets looks wrong for chunks, by
    // sizes that are in it. scanExr has checked that table.
    options.flags = EXR_CONTEXT_FLAG_DISABLE_CHUNK_RECONSTRUCTION;
    Decoder::check(exr_start_read(&decoder_->context, "memory", &options), where);
}

ExrPixels::~ExrPixels() = default;

std::vector<float> ExrPixels::read(size_t index, const ExrPart& part, const std::string& where)
{
    const size_t line = static_cast<size_t>(part.width) * static_cast<size_t>(part.channels);
    std::vector<float> pixels(line * static_cast<size_t>(part.height));
    // Lines are counted from the data window, which need not start at 0, and a part is read chunk
    // by chunk: a chunk is what is compressed as a whole.
    const int lines = linesPerChunk(part);
    for (int y = 0; y < part.height; y += lines)
        decoder_->readLines(static_cast<int>(index), part.firstLine + y, part,
                            pixels.data() + line * static_cast<size_t>(y), where);
    return pixels;
}

}  // namespace fbrdf
