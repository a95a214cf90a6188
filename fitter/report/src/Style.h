// Style.h - report.css, embedded by CMake.
#pragma once

namespace fbrdf {

extern const char* const kStyle;

}  // namespace fbrdf
