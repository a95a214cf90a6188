// Manifest.h - a material as JSON with one PNG for each table, for engines that do not read
// OpenEXR. docs/format.md specifies it.
#pragma once
#include <fbrdf/brdf/Material.h>

#include <string>

namespace fbrdf {

/// True for the first bytes (4 KB are enough) of a manifest.
bool looksLikeManifest(const std::string& beginning);

/// Reads the manifest `text` and its maps, which lie beside `path`. Throws Error(input) with file
/// and field.
Material readManifest(const std::string& text, const std::string& path);

/// Writes the manifest to `path` and its maps beside it. Throws Error(output).
void writeManifest(const Material& material, const std::string& path);

}  // namespace fbrdf
