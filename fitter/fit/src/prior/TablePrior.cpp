#include <fbrdf/fit/TablePrior.h>

#include "forms/BaseForms.h"
#include "prior/ShippedData.h"
#include "solve/Rows.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

namespace fbrdf {
namespace {

constexpr std::string_view kMagic = "fbrdf-prior 1 hdio";
constexpr int kMostModes = 1024;
constexpr float kMeanSteps = 65535.0f, kModeSteps = 127.0f;

struct PriorSizes {
    int half = 0, difference = 0, zenith = 0, modes = 0;
};

const GridDomain& gridOf(const Form& form, size_t table)
{
    return std::get<GridDomain>(form.tables[table].domain);
}

size_t numbersOf(const Form& form)
{
    return static_cast<size_t>(Layout(form).unknowns());
}

void putBits(std::string& bytes, uint32_t value, int count)
{
    for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i) & 255u);
}

void putFloat(std::string& bytes, float value)
{
    uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    putBits(bytes, bits, 4);
}

void putMean(std::string& bytes, const std::vector<float>& mean)
{
    const auto [low, high] = std::minmax_element(mean.begin(), mean.end());
    const float step = std::max((*high - *low) / kMeanSteps, 1e-30f);
    putFloat(bytes, *low);
    putFloat(bytes, step);
    for (const float m : mean)
        putBits(bytes, static_cast<uint32_t>(std::lround((m - *low) / step)), 2);
}

void putMode(std::string& bytes, const std::vector<float>& mode)
{
    float most = 1e-30f;
    for (const float m : mode) most = std::max(most, std::abs(m));
    const float step = most / kModeSteps;
    putFloat(bytes, step);
    for (const float m : mode)
        putBits(bytes, static_cast<uint32_t>(std::lround(m / step)) & 255u, 1);
}

/// Takes numbers off the front of bytes that are known to be enough.
class ByteReader {
public:
    explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}
    uint32_t bits(int count)
    {
        uint32_t value = 0;
        for (int i = 0; i < count; ++i)
            value |= static_cast<uint32_t>(static_cast<unsigned char>(bytes_[at_++])) << (8 * i);
        return value;
    }
    float real()
    {
        const uint32_t value = bits(4);
        float result = 0.0f;
        std::memcpy(&result, &value, sizeof result);
        return result;
    }

private:
    std::string_view bytes_;
    size_t at_ = 0;
};

[[noreturn]] void refuse(const std::string& where, const std::string& found,
                         const std::string& expected)
{
    throw Error(ErrorKind::input, where, Found(found).expected(expected));
}

int sizeFrom(std::string_view& text, int least, int most, const std::string& where)
{
    if (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    int value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc() || value < least || value > most)
        refuse(where, "'" + std::string(text.substr(0, 16)) + "' in the first line",
               "four numbers: texels of T1 and of T2, " + std::to_string(least) + " to " +
                   std::to_string(most) + ", and modes");
    text.remove_prefix(static_cast<size_t>(result.ptr - text.data()));
    return value;
}

PriorSizes sizesFrom(std::string_view line, const std::string& where)
{
    line.remove_prefix(kMagic.size());
    PriorSizes sizes;
    for (int* size : {&sizes.half, &sizes.difference, &sizes.zenith})
        *size = sizeFrom(line, 2, kMaxResolution, where);
    sizes.modes = sizeFrom(line, 1, kMostModes, where);
    if (!line.empty())
        refuse(where, "'" + std::string(line.substr(0, 16)) + "' after four numbers",
               "the end of the line");
    return sizes;
}

void requireFinite(const std::vector<float>& values, const std::string& where)
{
    for (const float v : values)
        if (!std::isfinite(v)) refuse(where, "a number that is not finite", "finite numbers");
}

}  // namespace

std::string tablePriorBytes(const TablePrior& prior)
{
    FBRDF_ASSERT(prior.mean.size(), ==, numbersOf(prior.form));
    const auto& axes = gridOf(prior.form, 0).axes;
    std::string bytes(kMagic);
    for (const int size : {axes[0].size, axes[1].size, gridOf(prior.form, 1).axes[0].size,
                           static_cast<int>(prior.modes.size())})
        bytes += " " + std::to_string(size);
    bytes += "\n";
    putMean(bytes, prior.mean);
    for (const auto& mode : prior.modes) putMode(bytes, mode);
    return bytes;
}

TablePrior tablePriorFromBytes(std::string_view bytes, const std::string& where)
{
    const size_t end = bytes.substr(0, 128).find('\n');
    if (bytes.substr(0, kMagic.size()) != kMagic || end == std::string_view::npos)
        refuse(where, "no line '" + std::string(kMagic) + " ...' at its start", "a prior file");
    const PriorSizes sizes = sizesFrom(bytes.substr(0, end), where);
    TablePrior prior;
    prior.form = formHdio({sizes.half, sizes.difference, sizes.zenith});
    const size_t numbers = numbersOf(prior.form), modes = static_cast<size_t>(sizes.modes);
    const size_t needed = end + 1 + 8 + 2 * numbers + modes * (4 + numbers);
    if (bytes.size() != needed)
        refuse(where, std::to_string(bytes.size()) + " bytes", std::to_string(needed));
    ByteReader reader(bytes.substr(end + 1));
    const float low = reader.real(), step = reader.real();
    for (size_t i = 0; i < numbers; ++i)
        prior.mean.push_back(low + step * static_cast<float>(reader.bits(2)));
    requireFinite(prior.mean, where);
    for (size_t k = 0; k < modes; ++k) {
        const float unit = reader.real();
        std::vector<float>& mode = prior.modes.emplace_back();
        for (size_t i = 0; i < numbers; ++i)
            mode.push_back(unit * static_cast<float>(static_cast<int8_t>(reader.bits(1))));
        requireFinite(mode, where);
    }
    return prior;
}

TablePrior shippedTablePrior()
{
    return tablePriorFromBytes(priorOfTables(), "the shipped prior");
}

}  // namespace fbrdf
