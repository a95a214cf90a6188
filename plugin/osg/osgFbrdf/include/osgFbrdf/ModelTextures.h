// ModelTextures.h - the textures of a model that live on under an effect, by their units. The
// texture coordinates are set 0, and what has no texture there is drawn as without.
#pragma once
#include <set>
#include <string>

namespace osgFbrdf {

/// Units: -1: none. The maps of the material keep out of them.
struct ModelTextures {
    /// Colours that multiply reflectance: codes of sRGB, which become linear. Their alpha is that
    /// of the model where alpha is none, times that of the osg::Material's diffuse colour, which
    /// core profiles do not have.
    int tint = -1;
    /// Its red is the alpha of the model.
    int alpha = -1;
    /// 2 texel - 1 is the normal in the tangent frame (kTangentAttribute, or derived tangents).
    int normal = -1;
    /// What the tint multiplies: true: the whole reflectance; false: its diffuse terms, which do
    /// not depend on the half vector or the difference, or all where none is diffuse.
    bool tintsAll = false;

    /// The model then has an alpha: its alpha test is kept, and what it blends is blended.
    bool hasAlpha() const { return tint >= 0 || alpha >= 0; }
    bool any() const { return hasAlpha() || normal >= 0; }
    std::set<int> units() const
    {
        std::set<int> units{tint, alpha, normal};
        units.erase(-1);
        return units;
    }
    bool operator==(const ModelTextures& other) const
    {
        return tint == other.tint && alpha == other.alpha && normal == other.normal &&
               tintsAll == other.tintsAll;
    }
};

}  // namespace osgFbrdf
