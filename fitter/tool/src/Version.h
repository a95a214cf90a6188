// Version.h - the version of the project, as CMake knows it.
#pragma once

namespace fbrdf::tool {

constexpr char kVersion[] = FBRDF_VERSION;

}  // namespace fbrdf::tool
