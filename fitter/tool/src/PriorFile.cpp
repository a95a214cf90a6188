#include "PriorFile.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <fstream>

namespace fbrdf::tool {

TablePrior readPrior(const std::string& path)
{
    constexpr size_t kMostBytes = size_t{64} << 20;
    std::ifstream file(path, std::ios::binary);
    std::string bytes(kMostBytes, '\0');
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (file.bad() || !file.is_open())
        throw Error(ErrorKind::input, path, Found("no file to read").expected("a prior file"));
    bytes.resize(static_cast<size_t>(file.gcount()));
    return tablePriorFromBytes(bytes, path);
}

}  // namespace fbrdf::tool
