#include "BrdfOptions.h"

#include <fbrdf/base/Number.h>
#include <fbrdf/base/Text.h>

#include <map>

namespace ogreFbrdf {
namespace {

const std::map<std::string, fbrdf::Transfer>& transfers()
{
    static const std::map<std::string, fbrdf::Transfer> known{
        {"linear", fbrdf::Transfer::linear},
        {"srgb", fbrdf::Transfer::srgb},
        {"tone-map", fbrdf::Transfer::toneMap}};
    return known;
}

/// False for a value out of range.
bool setTransfer(BrdfOptions& options, const std::string& value)
{
    const auto known = transfers().find(value);
    if (known != transfers().end()) options.transfer = known->second;
    return known != transfers().end();
}

bool setExposure(BrdfOptions& options, const std::string& value)
{
    double number = 0.0;
    if (!fbrdf::parseNumber(value, number) || !(number >= 0.0)) return false;
    options.exposure = static_cast<float>(number);
    return true;
}

bool isExact(float value, int digits)
{
    double number = 0.0;
    return fbrdf::parseNumber(fbrdf::numberText(static_cast<double>(value), digits), number) &&
           static_cast<float>(number) == value;
}

/// The shortest text that gives the number back.
std::string exactText(float value)
{
    int digits = 6;
    while (digits < 9 && !isExact(value, digits)) ++digits;
    return fbrdf::numberText(static_cast<double>(value), digits);
}

bool setFlag(bool& flag, const std::string& value)
{
    if (value != "0" && value != "1") return false;
    flag = value == "1";
    return true;
}

}  // namespace

std::string setOption(BrdfOptions& options, const std::string& name, const std::string& value)
{
    bool taken = !value.empty();
    if (name == "material")
        options.material = value;
    else if (name == "exposure")
        taken = setExposure(options, value);
    else if (name == "transfer")
        taken = setTransfer(options, value);
    else if (name == "preciseFiltering")
        taken = setFlag(options.preciseFiltering, value);
    else if (name == "normalMap")
        options.normalMap = value;
    else if (name == "technique")
        // One pass draws any number of lights, so there is no other technique to choose.
        value == "auto" || value == "single" || value == "diffuse"
            ? options.diffuse = value == "diffuse"
            : taken = false;
    else
        return "option '" + name + "': found no such option";
    return taken ? "" : "option '" + name + "=" + value + "': found a value out of range";
}

std::vector<std::pair<std::string, std::string>> optionsOf(const BrdfOptions& options)
{
    std::vector<std::pair<std::string, std::string>> list{{"material", options.material}};
    if (options.exposure != 1.0f) list.emplace_back("exposure", exactText(options.exposure));
    for (const auto& [name, transfer] : transfers())
        if (transfer == options.transfer && transfer != fbrdf::Transfer::linear)
            list.emplace_back("transfer", name);
    if (options.diffuse) list.emplace_back("technique", "diffuse");
    if (options.preciseFiltering) list.emplace_back("preciseFiltering", "1");
    if (!options.normalMap.empty()) list.emplace_back("normalMap", options.normalMap);
    return list;
}

}  // namespace ogreFbrdf
