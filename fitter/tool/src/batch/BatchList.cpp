#include "batch/BatchList.h"

#include "LineBlocks.h"
#include "PairRows.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <set>

namespace fbrdf::tool {
namespace {

[[noreturn]] void fail(const std::string& path, size_t line, const std::string& what)
{
    throw Error(ErrorKind::input, path + ":" + std::to_string(line), what);
}

// True for names that neither leave the output folder nor are hidden in it.
bool isFileName(const std::string& name)
{
    constexpr size_t kLongest = 200;  // file systems allow 255 bytes, the ending included
    return !name.empty() && name.size() <= kLongest && name.front() != '.' &&
           name.find('/') == std::string::npos;
}

BatchItem parseItem(const std::string& line, const std::string& path, size_t number)
{
    const size_t tab = line.find('\t');
    if (tab == std::string::npos || tab + 1 == line.size())
        fail(path, number, Found("'" + line.substr(0, 60) + "'").expected("name<TAB>source"));
    const BatchItem item{line.substr(0, tab), line.substr(tab + 1)};
    if (!isFileName(item.name))
        fail(path, number,
             Found("the name '" + item.name.substr(0, 60) + "'")
                 .expected("a file name without '/' and without a leading dot"));
    return item;
}

}  // namespace

std::string readListFile(const std::string& path)
{
    LineBlocks blocks(path);
    std::string text;
    for (LineBlock block; blocks.next(block);) text += block.text;
    return text;
}

std::vector<BatchItem> parseList(const std::string& text, const std::string& path)
{
    std::vector<BatchItem> items;
    std::set<std::string> names;
    std::string_view rest = text;
    for (size_t number = 1; !rest.empty(); ++number) {
        const std::string_view line = takeLine(rest);
        if (isSkipped(line)) continue;
        items.push_back(parseItem(std::string(line), path, number));
        if (!names.insert(items.back().name).second)
            fail(path, number,
                 Found("the name '" + items.back().name + "' again").expected("it once"));
    }
    if (items.empty())
        throw Error(ErrorKind::input, path, Found("no material").expected("lines name<TAB>source"));
    return items;
}

}  // namespace fbrdf::tool
