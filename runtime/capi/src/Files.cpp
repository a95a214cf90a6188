#include "Files.h"

#include <fbrdf/io/MaterialFile.h>

namespace fbrdf::capi {

Material readFile(const std::string& path)
{
    return readMaterial(path);
}

}  // namespace fbrdf::capi
