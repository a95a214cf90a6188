#include "PriorFile.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace fbrdf::tool {

TablePrior readPrior(const std::string& path)
{
    std::error_code ignored;
    std::ifstream file(path, std::ios::binary);
    if (!std::filesystem::is_regular_file(path, ignored) || !file)
        throw Error(ErrorKind::input, path, Found("no file to read").expected("a prior file"));
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    return tablePriorFromBytes(bytes, path);
}

}  // namespace fbrdf::tool
