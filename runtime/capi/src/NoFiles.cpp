#include "Files.h"

#include <fbrdf/base/Error.h>

namespace fbrdf::capi {

Material readFile(const std::string& path)
{
    throw Error(ErrorKind::usage, path,
                "found a library built without files, expected fbrdf_brdf_create");
}

}  // namespace fbrdf::capi
