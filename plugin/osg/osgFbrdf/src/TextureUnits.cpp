#include "TextureUnits.h"

#include <fbrdf/base/Assert.h>

#include <utility>

namespace osgFbrdf {
namespace {

std::string listed(const std::set<int>& units)
{
    std::string text;
    for (const int unit : units) text += (text.empty() ? "" : ",") + std::to_string(unit);
    return text;
}

}  // namespace

TextureUnits::TextureUnits(int first, std::set<int> kept) : first_(first), kept_(std::move(kept)) {}

int TextureUnits::operator[](int i) const
{
    FBRDF_ASSERT(i, >=, 0);
    int unit = first_ + i;
    for (const int kept : kept_) {
        if (kept > unit) break;
        unit += kept >= first_ ? 1 : 0;
    }
    return unit;
}

std::string TextureUnits::description() const
{
    return kept_.empty() ? "texture units"
                         : "texture units, of which others keep " + std::to_string(kept_.size());
}

std::string TextureUnits::key() const
{
    return std::to_string(first_) + '-' + listed(kept_);
}

}  // namespace osgFbrdf
