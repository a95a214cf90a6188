// ExrMaterial.h - the .fbrdf file: OpenEXR with one part for each table. docs/format.md specifies
// it.
#pragma once
#include <fbrdf/brdf/Material.h>

#include <string>

namespace fbrdf {

/// True for the first bytes (4 KB are enough) of a .fbrdf file.
bool looksLikeExrMaterial(const std::string& beginning);

/// Reads a whole file from its bytes. Throws Error(input) that names `where`, the part, and the
/// field or byte.
Material readExrMaterial(const std::string& bytes, const std::string& where);

/// Bytes of the whole file; the same material gives the same bytes. Throws Error(usage) that names
/// `where` for what the format cannot represent: texels that are not of their storage, keys above
/// 200 bytes, texts with a zero byte.
std::string encodeExrMaterial(const Material& material, const std::string& where);

}  // namespace fbrdf
