// MaterialFile.h - materials on disk: .fbrdf (multi-part OpenEXR), the 2001 Waterloo layout, PNG +
// JSON. docs/format.md describes the .fbrdf and the JSON exactly.
#pragma once
#include <fbrdf/brdf/Material.h>

#include <optional>
#include <string>

namespace fbrdf {

/// Reads a .fbrdf, a 2001 layout (path of its NAME.txt, or of the folder that it is in) or a
/// manifest NAME.json, recognised by content. Throws Error(input) with file and part.
Material readMaterial(const std::string& path);

/// True when the file looks like one that readMaterial reads, by its first bytes. False for what is
/// missing or cannot be read.
bool isMaterialFile(const std::string& path);

/// readMaterial of a path for which isMaterialFile is true, nothing for any other.
std::optional<Material> readIfMaterial(const std::string& path);

/// Writes by extension: .fbrdf, .txt (2001 layout, for forms that fit it), .json (manifest with one
/// PNG for each map). Files appear complete or not at all. Throws Error(output), or Error(usage)
/// for a form that the format cannot represent.
void writeMaterial(const Material& material, const std::string& path);

/// The material in the bytes of a whole .fbrdf, for example from inside another file. Throws
/// Error(input) that names `where`, which stands for a path, and the part.
Material materialFromFileBytes(const std::string& bytes, const std::string& where);

/// The bytes that writeMaterial writes to a .fbrdf. Throws Error(input) for a material that is not
/// valid, Error(usage) for one that the format cannot represent.
std::string materialFileBytes(const Material& material);

}  // namespace fbrdf
