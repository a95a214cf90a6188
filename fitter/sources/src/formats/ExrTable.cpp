// ExrTable.cpp - reflectance in OpenEXR images of any compression, scan lines or tiles. Channels R,
// G, B or X, Y, Z (of a layer, too: "diffuse.R") or a single one, with primaries and white as
// ExrImage.h has them. The string attributes "fbrdf:layout" and "fbrdf:theta_i" give layout and
// angles (ImageTable.h).
#include "Formats.h"

#include <fbrdf/base/Found.h>
#include "formats/ExrImage.h"

namespace fbrdf {

bool isExrTable(const InputFile& file)
{
    return isExr(file);
}

Source readExrTable(const FileRequest& request)
{
    const InputFile& file = *request.file;
    if (!isExrTable(file))
        throw inputError(file, 0, Found("no OpenEXR magic number").expected("it"));
    return sourceOfImage(file, readExrImage(file), "OpenEXR");
}

}  // namespace fbrdf
