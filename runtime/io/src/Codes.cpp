#include "Codes.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/base/Number.h>

#include <fbrdf/brdf/Half.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace fbrdf {
namespace {

constexpr int kLastCode = 255, kLastUnorm16 = 65535;
// Differences of UNORM16 lie within +-65535; rounding and the two spare codes add less than as
// much again.
constexpr int64_t kMaxOffset = 2 * kLastUnorm16;

[[noreturn]] void failInput(const std::string& where, const std::string& what)
{
    throw Error(ErrorKind::input, where, what);
}

bool holdsTexel(const Table& table, size_t position)
{
    const auto channels = static_cast<size_t>(table.channels);
    const int index = static_cast<int>(position / channels),
              channel = static_cast<int>(position % channels);
    const float texel = table.texels[position];
    switch (table.storage) {
        case Storage::float32: return true;
        case Storage::half:
        case Storage::signedHalf: return floatFromHalf(halfFromFloat(texel)) == texel;
        case Storage::log8:
        case Storage::linear8: break;
    }
    // The code of log8 is a difference to the texel before, so a texel may be possible in one place
    // and not in another.
    const int code = codeOf(table, index, channel);
    return code >= 0 && code <= kLastCode && texelFromCode(table, index, channel, code) == texel;
}

}  // namespace

bool knownStorage(const std::string& name, Storage& storage)
{
    for (const Storage s :
         {Storage::log8, Storage::half, Storage::float32, Storage::linear8, Storage::signedHalf}) {
        if (name != storageName(s)) continue;
        storage = s;
        return true;
    }
    return false;
}

std::vector<uint16_t> codesOfTable(const Table& table)
{
    std::vector<uint16_t> codes;
    codes.reserve(table.texels.size());
    for (int i = 0; i < texelCount(table.domain); ++i)
        for (int c = 0; c < table.channels; ++c)
            codes.push_back(static_cast<uint16_t>(codeOf(table, i, c)));
    return codes;
}

void checkCoding(const Table& table, const std::string& where)
{
    for (int c = 0; c < 3; ++c)
        if (!std::isfinite(table.lower[c]) || !std::isfinite(table.upper[c]) ||
            !std::isfinite(table.upper[c] - table.lower[c]))
            failInput(where, Found("a range that is not finite").expected("finite numbers"));
    if (table.storage == Storage::linear8 &&
        (table.lower != Vec3f(0.0f) || table.upper != Vec3f(1.0f)))
        failInput(where, Found("a range of linear8").expected("0 to 1"));
    if (table.storage != Storage::log8) return;
    for (size_t c = 0; c < static_cast<size_t>(table.channels); ++c) {
        const int64_t stride = table.log8.stride[c], offset = table.log8.offset[c],
                      start = table.log8.start[c];
        if (stride < 1 || stride > kLastUnorm16)
            failInput(where, Found("stride " + std::to_string(stride)).expected("1 to 65535"));
        if (start < 0 || start > kLastUnorm16)
            failInput(where, Found("start " + std::to_string(start)).expected("0 to 65535"));
        // With this bound every sum that a code leads to fits an int.
        if (std::abs(offset) * stride > kMaxOffset)
            failInput(where, Found("offset " + std::to_string(offset) + " and stride " +
                                   std::to_string(stride))
                                 .expected("a product within 131070"));
    }
}

void decodeTexels(Table& table, const std::string& where)
{
    const auto channels = static_cast<size_t>(table.channels);
    for (size_t i = 0; i < table.texels.size(); ++i) {
        const float code = table.texels[i];
        const int index = static_cast<int>(i / channels), channel = static_cast<int>(i % channels);
        if (!(code >= 0.0f) || !(code <= float(kLastCode)) || code != std::floor(code))
            failInput(where + ": texel " + std::to_string(index),
                      Found("code " + numberText(double(code))).expected("an integer of 0 to 255"));
        table.texels[i] = texelFromCode(table, index, channel, static_cast<int>(code));
        // A sum beyond 16 bits is no texel that a writer had; codes that lead to one would also
        // move all texels behind it.
        if (codeOf(table, index, channel) != static_cast<int>(code))
            failInput(
                where + ": texel " + std::to_string(index),
                Found("a code that leads out of the range of the table").expected("one within it"));
    }
}

std::string runsOfMarks(const std::vector<bool>& marks)
{
    std::string runs;
    bool marked = false;
    size_t length = 0;
    for (const bool mark : marks) {
        if (mark != marked) runs += std::to_string(std::exchange(length, 0)) + " ";
        marked = mark;
        ++length;
    }
    return runs + std::to_string(length);
}

std::vector<bool> marksFromRuns(const std::string& runs, int texels, const std::string& where)
{
    std::vector<bool> marks;
    const auto left = [&] { return static_cast<size_t>(texels) - marks.size(); };
    const char *at = runs.data(), *const end = at + runs.size();
    for (bool marked = false; at != end; marked = !marked) {
        size_t length = 0;
        const auto parsed = std::from_chars(at, end, length);
        if (parsed.ec != std::errc() || length > left())
            failInput(where, Found("runs of marks that are not numbers or too long")
                                 .expected("a sum of " + std::to_string(texels)));
        marks.insert(marks.end(), length, marked);
        at = parsed.ptr;
        if (at != end && *at == ' ') ++at;
    }
    if (left() != 0)
        failInput(where, Found("marks of " + std::to_string(marks.size()) + " texels")
                             .expected(std::to_string(texels)));
    return marks;
}

void checkStorable(const Table& table, ErrorKind kind, const std::string& where)
{
    for (size_t i = 0; i < table.texels.size(); ++i)
        if (!holdsTexel(table, i))
            throw Error(
                kind, where,
                "table '" + table.name + "': " +
                    Found(numberText(double(table.texels[i])))
                        .expected(std::string("numbers that ") + storageName(table.storage) +
                                  " holds: quantize the table first"));
}

}  // namespace fbrdf
