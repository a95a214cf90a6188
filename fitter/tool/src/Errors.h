// Errors.h - measured errors under the names of the metrics, in a fixed order, as JSON and as text.
// A value that does not exist (no sample above the floor) is not in the map.
#pragma once
#include <fbrdf/metrics/Metrics.h>
#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace fbrdf::tool {

using Json = nlohmann::ordered_json;
using ErrorMap = std::map<std::string, double>;

/// The PSNR of two identical pictures is infinite, which JSON and CSV cannot express; they get
/// this.
constexpr double kIdenticalPsnr = 999.0;

/// The finite values of the metrics.
ErrorMap errorMap(const SampleErrors& errors);
ErrorMap errorMap(const ImageErrors& errors);
ErrorMap errorMap(const PhysicsErrors& errors);

/// Every name that an ErrorMap may have, in the order in which they are shown.
const std::vector<std::string>& errorNames();

/// The errors in order; log_median_r, _g, _b become the array log_median_rgb.
Json jsonOf(const ErrorMap& errors);
/// Numbers with no more digits than a float needs to be read back exactly.
Json jsonOf(const Vec3f& colour);
Json jsonOf(const Vec3d& colour);
/// The number, or null where it is not finite.
Json jsonOf(double number);

/// One object, indented, with a newline at its end; invalid UTF-8 is replaced.
std::string text(const Json& json);

/// A row for each name that any of the maps has: name, a column for each map, meaning. `titles` are
/// the columns' headings; empty for none.
std::string errorTable(const std::vector<ErrorMap>& columns,
                       const std::vector<std::string>& titles);

}  // namespace fbrdf::tool
