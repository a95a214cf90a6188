#include <fbrdf/pictures/Png.h>

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <png.h>
#include <algorithm>
#include <csetjmp>
#include <cstring>

namespace fbrdf {
namespace {

constexpr size_t kMagicBytes = 8;
constexpr png_uint_32 kMaxPixels = 1u << 24;           // Form.cpp: no table has more texels
constexpr png_alloc_size_t kMaxChunkBytes = 1u << 20;  // of text and profiles, which are not used

/// What libpng's callbacks share with their caller.
struct Stream {
    const std::string* input = nullptr;
    size_t position = 0;
    std::string output, message;
};

// libpng reports an error by not returning. Between setjmp and here there are only frames of libpng
// and of functions that own nothing.
[[noreturn]] void onError(png_structp png, png_const_charp message)
{
    static_cast<Stream*>(png_get_error_ptr(png))->message = message;
    png_longjmp(png, 1);
}

void onWarning(png_structp, png_const_charp) {}

void onRead(png_structp png, png_bytep bytes, png_size_t count)
{
    auto& stream = *static_cast<Stream*>(png_get_io_ptr(png));
    if (count > stream.input->size() - stream.position) png_error(png, "the file ends early");
    std::memcpy(bytes, stream.input->data() + stream.position, count);
    stream.position += count;
}

void onWrite(png_structp png, png_bytep bytes, png_size_t count)
{
    auto& stream = *static_cast<Stream*>(png_get_io_ptr(png));
    stream.output.append(reinterpret_cast<const char*>(bytes), count);
}

void onFlush(png_structp) {}

class Reader {
public:
    explicit Reader(Stream& stream)
        : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &stream, onError, onWarning)),
          info(png_create_info_struct(png))
    {
        png_set_read_fn(png, &stream, onRead);
        png_set_chunk_malloc_max(png, kMaxChunkBytes);
    }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }

    png_structp png;
    png_infop info;
};

class PngWriter {
public:
    explicit PngWriter(Stream& stream)
        : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, &stream, onError, onWarning)),
          info(png_create_info_struct(png))
    {
        png_set_write_fn(png, &stream, onWrite, onFlush);
    }
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;
    ~PngWriter() { png_destroy_write_struct(&png, &info); }

    png_structp png;
    png_infop info;
};

bool readInfo(const Reader& reader)
{
    if (setjmp(png_jmpbuf(reader.png))) return false;
    png_read_info(reader.png, reader.info);
    png_set_expand(reader.png);
    png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
    return true;
}

bool readRows(const Reader& reader, png_bytepp rows)
{
    if (setjmp(png_jmpbuf(reader.png))) return false;
    png_read_image(reader.png, rows);
    png_read_end(reader.png, nullptr);
    return true;
}

int colourType(int channels)
{
    return channels == 1   ? PNG_COLOR_TYPE_GRAY
           : channels == 3 ? PNG_COLOR_TYPE_RGB
                           : PNG_COLOR_TYPE_RGB_ALPHA;
}

bool writeAll(const PngWriter& writer, const PngImage& image, png_bytepp rows)
{
    if (setjmp(png_jmpbuf(writer.png))) return false;
    png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(image.width),
                 static_cast<png_uint_32>(image.height), image.bits, colourType(image.channels),
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(writer.png, writer.info);
    png_write_image(writer.png, rows);
    png_write_end(writer.png, nullptr);
    return true;
}

std::vector<png_bytep> rowsOf(std::vector<png_byte>& bytes, int height)
{
    const size_t stride = bytes.size() / static_cast<size_t>(height);
    std::vector<png_bytep> rows;
    for (size_t y = 0; y < static_cast<size_t>(height); ++y)
        rows.push_back(bytes.data() + y * stride);
    return rows;
}

PngImage describe(const Reader& reader, const std::string& where)
{
    const png_uint_32 width = png_get_image_width(reader.png, reader.info),
                      height = png_get_image_height(reader.png, reader.info);
    if (width > kMaxPixels / height)
        throw Error(ErrorKind::input, where,
                    Found(std::to_string(width) + " x " + std::to_string(height) + " pixels")
                        .expected("at most 2^24"));
    const int channels = png_get_channels(reader.png, reader.info);
    if (channels != 1 && channels != 3)
        throw Error(ErrorKind::input, where,
                    Found(std::to_string(channels) + " channels").expected("1 or 3"));
    return {static_cast<int>(width),
            static_cast<int>(height),
            channels,
            png_get_bit_depth(reader.png, reader.info),
            {}};
}

}  // namespace

std::string encodePng(const PngImage& image, const std::string& where)
{
    FBRDF_ASSERT((image.bits == 8 || image.bits == 16), ==, true);
    FBRDF_ASSERT((image.channels == 1 || image.channels == 3 || image.channels == 4), ==, true);
    FBRDF_ASSERT(image.codes.size(), ==,
                 static_cast<size_t>(image.width) * static_cast<size_t>(image.height) *
                     static_cast<size_t>(image.channels));
    std::vector<png_byte> bytes;  // the higher byte of 16 bits comes first
    for (const uint16_t code : image.codes) {
        if (image.bits == 16) bytes.push_back(static_cast<png_byte>(code >> 8));
        bytes.push_back(static_cast<png_byte>(code & 0xff));
    }
    Stream stream;
    const PngWriter writer(stream);
    std::vector<png_bytep> rows = rowsOf(bytes, image.height);
    if (!writeAll(writer, image, rows.data()))
        throw Error(ErrorKind::output, where, "libpng: " + stream.message);
    return stream.output;
}

PngImage decodePng(const std::string& bytes, const std::string& where)
{
    if (bytes.size() < kMagicBytes ||
        png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, kMagicBytes) != 0)
        throw Error(ErrorKind::input, where, Found("other first bytes").expected("a PNG file"));
    Stream stream;
    stream.input = &bytes;
    const Reader reader(stream);
    const auto fail = [&] {
        throw Error(ErrorKind::input, where + ": byte " + std::to_string(stream.position),
                    "found a damaged PNG file: " + stream.message);
    };
    if (!readInfo(reader)) fail();
    PngImage image = describe(reader, where);
    std::vector<png_byte> pixels(png_get_rowbytes(reader.png, reader.info) *
                                 static_cast<size_t>(image.height));
    std::vector<png_bytep> rows = rowsOf(pixels, image.height);
    if (!readRows(reader, rows.data())) fail();
    const size_t step = image.bits == 16 ? 2 : 1;
    for (size_t i = 0; i < pixels.size(); i += step)
        image.codes.push_back(
            static_cast<uint16_t>(step == 2 ? pixels[i] << 8 | pixels[i + 1] : pixels[i]));
    return image;
}

}  // namespace fbrdf
