/* PictureModule.h - what fbrdf::codecs asks of the module that links OpenImageIO. Plain C: no
 * exception and no object of C++ crosses it. Every function of the module returns 0 for success;
 * otherwise it has written one line without a full stop, the reason, to `why` (ended by a zero
 * byte, cut to whySize). Images are top row first, channel contiguous, then x, then y.
 *
 * The module exports one function, FBRDF_PICTURE_MODULE_FUNCTION, of type
 * fbrdf_picture_module_function. */
#pragma once
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Raised by every change of this file; a module of another version is refused. */
#define FBRDF_PICTURE_MODULE_VERSION 3
#define FBRDF_PICTURE_MODULE_FUNCTION "fbrdf_open_picture_module"

struct fbrdf_picture_to_write {
    int width, height, channels; /* channels: 1, 3 or 4 */
    const float* pixels;         /* width x height x channels */
    int bits;                    /* of a sample in the file: 8 or 16 (of [0, 1]), 32 for floats */
    const char* colourSpace;     /* "sRGB" or "lin_rec709" */
};

/* Pictures that are shown one after the other, width x height x 3 codes of sRGB each. */
struct fbrdf_frames_to_write {
    int width, height, framesPerSecond, count;
    const unsigned char* const* frames; /* count of them */
};

/* The bytes of an encoded file, valid during the call. */
typedef void (*fbrdf_take_bytes)(void* context, const void* bytes, size_t size);

struct fbrdf_picture_found {
    int width, height, channels;
    const char* channelNames; /* with a comma between two */
    const char* colourSpace;  /* as the file declares it, "" where it does not */
    const char* sampleType;   /* in the file: "uint8", "half", "float", ... */
};

/* Returns memory for width x height x channels floats, or null to refuse the picture. Must not
 * throw. */
typedef float* (*fbrdf_give_memory)(void* context, const struct fbrdf_picture_found* found);

/* An image of a file, and its place: a file may store a part of the picture that it is of. */
struct fbrdf_picture_part {
    struct fbrdf_picture_found found; /* of what is stored */
    int x, y;                         /* of its first column and row within the picture */
    int pictureWidth, pictureHeight;
    int isTiled, tileWidth, tileHeight;
};

/* Returns 0 to try the next image of the file, or the number of channels to decode, which begin at
 * *firstChannel; negative to refuse the file. Must not throw. */
typedef int (*fbrdf_choose_part)(void* context, const struct fbrdf_picture_part* part,
                                 int* firstChannel);

/* Takes the next rows of the part, rows x width x chosen channels floats, valid during the call.
 * Returns 0, or something else to stop. Must not throw. */
typedef int (*fbrdf_take_rows)(void* context, const float* pixels, int rows);

struct fbrdf_picture_module {
    int version; /* FBRDF_PICTURE_MODULE_VERSION of the module */
    /* `format` is a name of OpenImageIO's: "jpeg", "tiff", ... */
    int (*encode)(const char* format, const struct fbrdf_picture_to_write* picture,
                  fbrdf_take_bytes take, void* context, char* why, size_t whySize);
    /* Calls `give` once, when the header is known. Integer samples become [0, 1]; no curve is
     * undone. */
    int (*decode)(const char* format, const void* bytes, size_t size, fbrdf_give_memory give,
                  void* context, char* why, size_t whySize);
    /* The same for pictures that need not fit into memory: calls `choose` for the flat images of
     * the file until one is chosen, then `take` until it has all rows. */
    int (*decodeRows)(const char* format, const void* bytes, size_t size, fbrdf_choose_part choose,
                      fbrdf_take_rows take, void* context, char* why, size_t whySize);
    /* Of a format with several images a file. */
    int (*encodeFrames)(const char* format, const struct fbrdf_frames_to_write* frames,
                        fbrdf_take_bytes take, void* context, char* why, size_t whySize);
};

typedef const struct fbrdf_picture_module* (*fbrdf_picture_module_function)(void);

#ifdef __cplusplus
}
#endif
