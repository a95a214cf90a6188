// TextureUnits.h - the texture units that the textures of a pass take: those from a first one on,
// but for some that others keep.
#pragma once
#include <set>
#include <string>

namespace osgFbrdf {

class TextureUnits {
public:
    TextureUnits() = default;
    TextureUnits(int first, std::set<int> kept);

    /// The unit of texture i, i >= 0.
    int operator[](int i) const;
    /// How many units a context must have for so many textures.
    int needed(int textures) const { return textures > 0 ? (*this)[textures - 1] + 1 : first_; }
    /// "texture units", with those that others keep, for a message.
    std::string description() const;
    std::string key() const;

private:
    int first_ = 0;
    std::set<int> kept_;
};

}  // namespace osgFbrdf
