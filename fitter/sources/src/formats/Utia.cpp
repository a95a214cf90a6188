// Utia.cpp - UTIA's BRDF database in .bin files: float64 (as published) or float32, little endian,
// without a header, one plane of 288 x 288 cells for R, G and B; UtiaTable.h has the grid. wi is
// their i (light), wo their v (view), both away from the surface; without the cosine. This follows
// the readers published with the database (Filip's TBDRF.cpp, by way of ALTA's plugin data_utia)
// and, based on it, by Sztrajman (read_brdf.py). The scale is the database's own; no such file was
// at hand.
// Encoding: the makers' description of data (btf.utia.cas.cz/?data_des) tells that of their
// pictures alone: PNG in sRGB, EXR in XYZ under D65. Their readers give numbers as they are;
// Sztrajman's calls them "linear gamma RGB" where it writes EXR, and writes the same ones to PNG.
// They are taken as linear; FILE@srgb undoes the curve of sRGB. Beyond 75 degrees: both readers go
// on linearly from 60 and 75 degrees, which is often below 0. The value at 75 is kept;
// FILE@extrapolated does as they do. FILE@srgb/extrapolated does both.
#include "Formats.h"
#include "formats/UtiaTable.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/base/Text.h>

#include <cmath>
#include <cstring>

namespace fbrdf {
namespace {

constexpr size_t kValues = 3 * kUtiaCells;

template <class T>
std::vector<Vec3f> readPlanes(std::string_view bytes)
{
    std::vector<Vec3f> cells(kUtiaCells);
    for (size_t i = 0; i < kValues; ++i) {
        T value;
        std::memcpy(&value, bytes.data() + i * sizeof(T), sizeof(T));
        cells[i % kUtiaCells][int(i / kUtiaCells)] = static_cast<float>(value);
    }
    return cells;
}

struct UtiaChoice {
    bool srgb = false;
    UtiaBeyond beyond = UtiaBeyond::kept;
};

UtiaChoice utiaChoice(const FileRequest& request)
{
    UtiaChoice choice;
    std::vector<std::string_view> words;
    if (!request.choice.empty()) splitFields(request.choice, '/', words);
    for (const std::string_view word : words) {
        if (sameWord(word, "srgb"))
            choice.srgb = true;
        else if (sameWord(word, "extrapolated"))
            choice.beyond = UtiaBeyond::extrapolated;
        else
            throw Error(ErrorKind::usage, request.file->path(),
                        Found("the choice " + inQuotes(word)).expected("srgb or extrapolated"));
    }
    return choice;
}

/// IEC 61966-2-1, continued above 1 and mirrored below 0.
float linearFromSrgb(float encoded)
{
    const float size = std::abs(encoded);
    const float linear =
        size <= 0.04045f ? size / 12.92f : std::pow((size + 0.055f) / 1.055f, 2.4f);
    return std::copysign(linear, encoded);
}

/// Anything else in a file of that size would read as numbers like 1e-200 and 1e250.
void requirePlausible(const InputFile& file, const std::vector<Vec3f>& cells)
{
    constexpr float kLargest = 1e6f;
    size_t plausible = 0;
    for (const Vec3f& f : cells) {
        const float sum = std::abs(f.x) + std::abs(f.y) + std::abs(f.z);
        plausible += sum > 0.0f && sum < kLargest;
    }
    if (plausible < cells.size() / 2)
        throw inputError(file, Found(std::to_string(plausible) + " of " +
                                     std::to_string(cells.size()) + " cells between 0 and 1e6")
                                   .expected("most"));
}

}  // namespace

bool isUtia(const InputFile& file)
{
    return file.size() == kValues * sizeof(double) || file.size() == kValues * sizeof(float);
}

Source readUtia(const FileRequest& request)
{
    const InputFile& file = *request.file;
    if (!isUtia(file))
        throw inputError(file, Found(std::to_string(file.size()) + " bytes")
                                   .expected(std::to_string(kValues * sizeof(double)) + " or " +
                                             std::to_string(kValues * sizeof(float)) +
                                             " (3 x 288 x 288 numbers)"));
    std::vector<Vec3f> cells = file.size() == kValues * sizeof(double)
                                   ? readPlanes<double>(file.bytes())
                                   : readPlanes<float>(file.bytes());
    requirePlausible(file, cells);
    const UtiaChoice choice = utiaChoice(request);
    if (choice.srgb)
        for (Vec3f& f : cells) f = {linearFromSrgb(f.x), linearFromSrgb(f.y), linearFromSrgb(f.z)};
    Source source = makeUtiaSource(std::move(cells), choice.beyond);
    source.assumptions.emplace_back(choice.srgb ? "R, G, B are encoded as sRGB"
                                                : "R, G, B are linear; FILE@srgb decodes sRGB");
    return source;
}

}  // namespace fbrdf
