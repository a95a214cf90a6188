// Files.h - reading materials, where the library is built with files (FBRDF_CAPI_FILES): they bring
// OpenImageIO into the host's process.
#pragma once
#include <fbrdf/brdf/Material.h>

#include <string>

namespace fbrdf::capi {

/// Throws Error(input), or Error(usage) in a library without files.
Material readFile(const std::string& path);

}  // namespace fbrdf::capi
