// Scattered.cpp - headerless text of scattered samples.
// '#' comments; rows of numbers separated by white space, commas or semicolons (Fields.h), all of
// one length:
//   7 columns  theta_i phi_i theta_o phi_o R G B       angles in radians, or degrees
//   9 columns  wi_x wi_y wi_z wo_x wo_y wo_z R G B     light first, any length
// Both directions point away from the surface in the tangent frame, x along the tangent; linear RGB
// in 1/sr without the cosine. Such files say nothing of themselves: order and units are assumed,
// and the angles are radians unless a zenith angle is above pi (NumberRows.h).
#include "Formats.h"

#include <fbrdf/base/Found.h>
#include "NumberRows.h"

namespace fbrdf {
namespace {

constexpr size_t kAngleColumns = 7, kVectorColumns = 9;

bool isColumnCount(size_t count)
{
    return count == kAngleColumns || count == kVectorColumns;
}

}  // namespace

bool isScattered(const InputFile& file)
{
    if (!looksLikeText(file.bytes())) return false;
    LineReader lines(file.bytes());
    std::string_view line;
    std::vector<std::string_view> words;
    double ignored = 0.0;
    if (!lines.nextData(line)) return false;
    splitNumbers(line, words);
    for (const std::string_view word : words)
        if (!parseField(word, ignored)) return false;
    return isColumnCount(words.size());
}

Source readScattered(const FileRequest& request)
{
    const InputFile& file = *request.file;
    LineReader lines(file.bytes());
    std::string_view line;
    std::vector<std::string_view> words;
    std::vector<double> v;
    size_t columns = 0;
    AngleRows angles;
    Source source;
    while (lines.nextData(line)) {
        splitNumbers(line, words);
        if (columns == 0) {
            columns = words.size();
            if (columns == kAngleColumns)
                angles.reserve(mostRows(file, columns));
            else
                source.samples.reserve(mostRows(file, columns));
        }
        if (!isColumnCount(columns) || words.size() != columns)
            throw lineError(
                file, lines.number(),
                Found(std::to_string(words.size()) + " numbers").expected("7 or 9 in every row"));
        parseNumbers(file, lines.number(), words, v);
        if (columns == kAngleColumns)
            angles.add(v[0], v[1], v[2], v[3], {v[4], v[5], v[6]});
        else
            addRow({{v[3], v[4], v[5]}, {v[0], v[1], v[2]}, {v[6], v[7], v[8]}}, source.samples,
                   source.report);
    }
    angles.addTo(source);
    source.description = std::string("scattered samples, linear RGB, 1/sr, ") +
                         (columns == kVectorColumns ? "directions"
                          : angles.inDegrees()      ? "angles in degrees"
                                                    : "angles in radians");
    source.assumptions.emplace_back(columns == kVectorColumns ? "columns are wi, wo, RGB"
                                                              : "columns are wi, wo angles, RGB");
    if (columns == kAngleColumns) source.assumptions.push_back(angles.assumption());
    requireSamples(source, file.path());
    return source;
}

}  // namespace fbrdf
