// MaterialFile.h - materials on disk: .fbrdf (multi-part OpenEXR), the 2001 Waterloo layout, PNG +
// JSON. The only part of the runtime that sees OpenImageIO; engines that make materials from memory
// do not link it.
#pragma once
#include <fbrdf/brdf/Material.h>

#include <string>

namespace fbrdf {

/// Reads a .fbrdf, a 2001 layout (path of its NAME.txt, or of a folder that holds one) or a
/// manifest NAME.json, recognised by content. Throws Error(input) with file and part.
Material readMaterial(const std::string& path);

/// True when the file looks like one that readMaterial reads, by its first bytes.
bool isMaterialFile(const std::string& path);

/// Writes by extension: .fbrdf, .txt (2001 layout; only forms it can hold), .json (manifest + one
/// PNG a map). Files appear whole or not at all. Throws Error(output), or Error(usage) for a form
/// that the format cannot hold.
void writeMaterial(const Material& material, const std::string& path);

/// The material of the bytes of a whole .fbrdf, as from inside another file. Throws Error(input)
/// with `where`, which stands for a path, and part.
Material materialFromFileBytes(const std::string& bytes, const std::string& where);

/// The bytes that writeMaterial writes to a .fbrdf. Throws as it does: OpenImageIO writes several
/// parts to files only, so there is one for a moment, in the folder for temporary files.
std::string materialFileBytes(const Material& material);

}  // namespace fbrdf
