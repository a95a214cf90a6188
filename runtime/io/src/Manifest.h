// Manifest.h - a material as JSON and one PNG a table, for engines that read neither OpenEXR nor
// .fbrdf.
// {"format": "fbrdf-material", "version": 1, "name": ..., "units": "1/sr",
//  "colorspace": "lin_rec709", "form": (FormJson.h), "scales": [[r, g, b] a term],
//  "maps": [{"table": "p", "file": "NAME_p.png", "storage": "log8", "bits": 16,
//            "lower": [r, g, b], "upper": [r, g, b],
//            "log8": {"stride": [...], "offset": [...], "start": [...]}, "unsupported": "5 2 9"}],
//  "notes": {...}, "errors": {...}}
// Code k of a channel means lower + (upper - lower) k / (2^bits - 1): log2 F for the log storages,
// F for linear8, so a PNG can be used as a texture as it is. linear8 has 8 bits. log8 has the
// 16-bit integers that its 8-bit differences add up to (Table.h: Log8); both come back bit for bit.
// "unsupported", where the fit said so: texels that no sample supports, as in ExrMaterial.h.
// half and float become 16-bit codes over the range of their texels and come back within half a
// step. Texel (x, y, z) is pixel (x, y + z size_y); the first row of the PNG is y = 0.
#pragma once
#include <fbrdf/brdf/Material.h>

#include <string>

namespace fbrdf {

/// True for the first bytes (4 KB are enough) of a manifest.
bool looksLikeManifest(const std::string& beginning);

/// `text`: the manifest; maps are found beside `path`. Throws Error(input) with file and field.
Material readManifest(const std::string& text, const std::string& path);

/// Throws Error(output).
void writeManifest(const Material& material, const std::string& path);

}  // namespace fbrdf
