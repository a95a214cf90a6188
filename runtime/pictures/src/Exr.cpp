#include <fbrdf/pictures/Exr.h>

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Error.h>

#include <OpenEXR/openexr.h>
#include <algorithm>
#include <cstdint>
#include <cstring>

namespace fbrdf {
namespace {

// The specification allows names of 31 bytes; longer ones, up to 255, are announced by a flag.
constexpr size_t kShortName = 31;

int64_t onWrite(exr_const_context_t, void* user, const void* data, uint64_t count, uint64_t offset,
                exr_stream_error_func_ptr_t)
{
    std::string& bytes = *static_cast<std::string*>(user);
    const auto end = static_cast<size_t>(offset + count);
    if (bytes.size() < end) bytes.resize(end);
    std::memcpy(bytes.data() + offset, data, static_cast<size_t>(count));
    return static_cast<int64_t>(count);
}

// Without a handler OpenEXR would print. It calls this with its context locked, so the context
// cannot be asked whose it is.
void ignoreMessage(exr_const_context_t, exr_result_t, const char*) {}

/// Sets one attribute of one part.
struct SetAttribute {
    exr_context_t context;
    int part;
    const char* name;

    exr_result_t operator()(const std::string& text) const
    {
        // OpenEXR measures texts itself where it is told no length, and refuses empty ones with it.
        return exr_attr_set_string(context, part, name, text.c_str());
    }
    exr_result_t operator()(int number) const
    {
        return exr_attr_set_int(context, part, name, number);
    }
    exr_result_t operator()(double number) const
    {
        return exr_attr_set_double(context, part, name, number);
    }
    exr_result_t operator()(const std::array<int, 3>& v) const
    {
        exr_attr_v3i_t triple{};
        std::copy(v.begin(), v.end(), triple.arr);
        return exr_attr_set_v3i(context, part, name, &triple);
    }
    exr_result_t operator()(const std::array<float, 3>& v) const
    {
        exr_attr_v3f_t triple{};
        std::copy(v.begin(), v.end(), triple.arr);
        return exr_attr_set_v3f(context, part, name, &triple);
    }
    exr_result_t operator()(const std::vector<float>& numbers) const
    {
        return exr_attr_set_float_vector(context, part, name, static_cast<int>(numbers.size()),
                                         numbers.data());
    }
};

/// Names of channels in the order of ExrImage::pixels.
const char* channelName(int channels, int channel)
{
    return channels == 1 ? "Y" : &"R\0G\0B\0A"[2 * channel];
}

int channelOf(int channels, const char* name)
{
    int channel = 0;
    while (std::strcmp(channelName(channels, channel), name) != 0) ++channel;
    return channel;
}

using Compress = exr_result_t (*)(exr_encode_pipeline_t*);

// A chunk is stored as it is where ZIP does not make it smaller, and readers know it by its size.
// OpenEXR 3.1.5 forgets that where both sizes are equal.
exr_result_t compressOrKeep(exr_encode_pipeline_t* encoder)
{
    const exr_result_t result = (*static_cast<Compress*>(encoder->encoding_user_data))(encoder);
    if (result != EXR_ERR_SUCCESS || encoder->compressed_bytes != encoder->packed_bytes)
        return result;
    std::memcpy(encoder->compressed_buffer, encoder->packed_buffer, encoder->compressed_bytes);
    return result;
}

class ExrWriter {
public:
    explicit ExrWriter(const std::string& where) : where_(where)
    {
        exr_context_initializer_t options = EXR_DEFAULT_CONTEXT_INITIALIZER;
        options.error_handler_fn = ignoreMessage;
        options.user_data = &bytes_;
        options.write_fn = onWrite;
        check(exr_start_write(&context_, "memory", EXR_WRITE_FILE_DIRECTLY, &options));
    }
    ExrWriter(const ExrWriter&) = delete;
    ExrWriter& operator=(const ExrWriter&) = delete;
    ~ExrWriter()
    {
        if (context_) exr_finish(&context_);
    }

    void addPart(const ExrImage& image, const exr_attr_box2i_t& display)
    {
        int part = 0;
        check(exr_add_part(context_, image.name.c_str(), EXR_STORAGE_SCANLINE, &part));
        exr_attr_box2i_t data{};
        data.max.x = image.width - 1;
        data.max.y = image.height - 1;
        const exr_attr_v2f_t centre{};
        check(exr_initialize_required_attr(context_, part, &display, &data, 1.0f, &centre, 1.0f,
                                           EXR_LINEORDER_INCREASING_Y, EXR_COMPRESSION_ZIP));
        for (int c = 0; c < image.channels; ++c)
            check(exr_add_channel(context_, part, channelName(image.channels, c),
                                  image.half ? EXR_PIXEL_HALF : EXR_PIXEL_FLOAT,
                                  EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1));
        for (const auto& [name, value] : image.attributes)
            check(std::visit(SetAttribute{context_, part, name.c_str()}, value));
    }
    void useLongNames() { check(exr_set_longname_support(context_, 1)); }
    void writeHeader() { check(exr_write_header(context_)); }
    void writePixels(int part, const ExrImage& image)
    {
        int lines = 0;
        check(exr_get_scanlines_per_chunk(context_, part, &lines));
        for (int y = 0; y < image.height; y += lines) writeChunk(part, image, y);
    }
    std::string finish()
    {
        check(exr_finish(&context_));
        return std::move(bytes_);
    }

private:
    void writeChunk(int part, const ExrImage& image, int y)
    {
        exr_chunk_info_t chunk{};
        exr_encode_pipeline_t encoder{};  // all zeros, as EXR_ENCODE_PIPELINE_INITIALIZER
        check(exr_write_scanline_chunk_info(context_, part, y, &chunk));
        exr_result_t result = exr_encoding_initialize(context_, part, &chunk, &encoder);
        if (result == EXR_ERR_SUCCESS) {
            takePixelsFrom(image, y, encoder);
            result = exr_encoding_choose_default_routines(context_, part, &encoder);
        }
        Compress compress = encoder.compress_fn;
        encoder.encoding_user_data = &compress;
        encoder.compress_fn = compressOrKeep;
        if (result == EXR_ERR_SUCCESS) result = exr_encoding_run(context_, part, &encoder);
        exr_encoding_destroy(context_, &encoder);
        check(result);
    }

    static void takePixelsFrom(const ExrImage& image, int y, exr_encode_pipeline_t& encoder)
    {
        const int pixelBytes = image.channels * static_cast<int>(sizeof(float)),
                  lineBytes = image.width * pixelBytes;
        const auto* line = reinterpret_cast<const uint8_t*>(image.pixels.data()) +
                           static_cast<size_t>(y) * static_cast<size_t>(lineBytes);
        for (int c = 0; c < encoder.channel_count; ++c) {
            exr_coding_channel_info_t& channel = encoder.channels[c];
            const int index = channelOf(image.channels, channel.channel_name);
            channel.user_data_type = EXR_PIXEL_FLOAT;
            channel.user_bytes_per_element = sizeof(float);
            channel.user_pixel_stride = pixelBytes;
            channel.user_line_stride = lineBytes;
            channel.encode_from_ptr = line + static_cast<size_t>(index) * sizeof(float);
        }
    }

    void check(exr_result_t result) const
    {
        if (result == EXR_ERR_SUCCESS) return;
        throw Error(
            ErrorKind::output, where_,
            std::string("cannot be written as OpenEXR: ") + exr_get_default_error_message(result));
    }

    std::string where_;
    std::string bytes_;
    exr_context_t context_ = nullptr;
};

bool hasLongNames(const std::vector<ExrImage>& images)
{
    return std::any_of(images.begin(), images.end(), [](const ExrImage& image) {
        return std::any_of(image.attributes.begin(), image.attributes.end(),
                           [](const auto& a) { return a.first.size() > kShortName; });
    });
}

// OpenEXR demands one display window for all parts of a file.
exr_attr_box2i_t displayWindow(const std::vector<ExrImage>& images)
{
    exr_attr_box2i_t window{};
    for (const ExrImage& image : images) {
        window.max.x = std::max(window.max.x, image.width - 1);
        window.max.y = std::max(window.max.y, image.height - 1);
    }
    return window;
}

void assertComplete(const ExrImage& image)
{
    FBRDF_ASSERT(image.width, >, 0);
    FBRDF_ASSERT(image.height, >, 0);
    FBRDF_ASSERT((image.channels == 1 || image.channels == 3 || image.channels == 4), ==, true);
    FBRDF_ASSERT(image.pixels.size(), ==,
                 static_cast<size_t>(image.width) * static_cast<size_t>(image.height) *
                     static_cast<size_t>(image.channels));
}

}  // namespace

std::string encodeExr(const std::vector<ExrImage>& images, const std::string& where)
{
    FBRDF_ASSERT(images.size(), >, 0u);
    for (const ExrImage& image : images) assertComplete(image);
    const exr_attr_box2i_t display = displayWindow(images);
    ExrWriter writer(where);
    if (hasLongNames(images)) writer.useLongNames();
    for (const ExrImage& image : images) writer.addPart(image, display);
    writer.writeHeader();
    for (size_t i = 0; i < images.size(); ++i) writer.writePixels(static_cast<int>(i), images[i]);
    return writer.finish();
}

}  // namespace fbrdf
