// ShippedData.h - the files of fitter/fit/data, which EmbedFile.cmake compiles in.
#pragma once
#include <string_view>

namespace fbrdf {

std::string_view priorOfTables();     ///< bytes for tablePriorFromBytes
std::string_view planOfHemisphere();  ///< text for planFromText
std::string_view planInPlane();       ///< the same

}  // namespace fbrdf
