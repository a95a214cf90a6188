#include "LabelFont.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

namespace fbrdf::viewer {

struct LabelFont::State {};

bool LabelFont::isThere()
{
    return false;
}

LabelFont::LabelFont(int)
{
    throw Error(ErrorKind::usage, "labels",
                Found("a build without Dear ImGui").expected("one with it (Debian: libimgui-dev)"));
}

LabelFont::~LabelFont() = default;

int LabelFont::height() const
{
    return 0;
}

int LabelFont::widthOf(const std::string&) const
{
    return 0;
}

void LabelFont::draw(scene::Image&, const LabelPlace&, const std::string&, float) const {}

}  // namespace fbrdf::viewer
