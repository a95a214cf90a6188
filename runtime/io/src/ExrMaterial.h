// ExrMaterial.h - the .fbrdf file: one OpenEXR part a table.
// Part k holds form.tables[k]: x along the width, y then z down the lines; channels R, G, B or Y.
// half and float storages hold their numbers; log8 and linear8 hold their codes 0..255 as half.
// The header of part 0 describes the material:
//   fbrdf:version int, fbrdf:form string (FormJson.h), fbrdf:scales float[3 x terms],
//   fbrdf:units "1/sr", fbrdf:colorspace "lin_rec709", fbrdf:name string,
//   fbrdf:note:KEY string, fbrdf:error:METRIC double;
// that of every part describes its table:
//   fbrdf:storage string, fbrdf:lower and fbrdf:upper float[3] (range of log8 and linear8), and for
//   log8 fbrdf:stride, fbrdf:offset, fbrdf:start int[3] (Table.h: Log8);
//   fbrdf:unsupported string, where the fit said so: texels that no sample supports, as lengths of
//   runs of texels in storage order, the first without the mark ("5 2 9": texels 5 and 6 of 16).
#pragma once
#include <fbrdf/brdf/Material.h>

#include <string>

namespace fbrdf {

/// True for the first bytes (4 KB are enough) of a .fbrdf file.
bool looksLikeExrMaterial(const std::string& beginning);

/// `bytes`: the whole file. Throws Error(input) naming `where`, the part and the field or byte.
Material readExrMaterial(const std::string& bytes, const std::string& where);

/// Bytes of the whole file; the same material gives the same bytes. Throws Error(usage) that names
/// `where` for what a file cannot hold: texels that are not of their storage, keys above 200 bytes,
/// zero bytes in texts.
std::string encodeExrMaterial(const Material& material, const std::string& where);

}  // namespace fbrdf
