// ReceivedShadows.h - the shadow maps that a technique of osgShadow, or a host that sets state as
// they do, lays over what is culled: textures with generated coordinates in the state above.
//
// Where a map lies, and which light it belongs to, is known only when drawing begins, as techniques
// cull what receives shadows before they aim the map (ShadowPlacement.h).
#pragma once
#include <osg/ref_ptr>
#include <osg/Texture>

#include <set>
#include <string>
#include <vector>

namespace osgUtil {
class CullVisitor;
}

namespace osgFbrdf {

class InheritedState;
struct SceneLights;

/// How programs look into the maps.
enum class ShadowFilter {
    plain,     ///< one comparison of depths, as fine as the texture filters
    jittered,  ///< SoftShadowMap: 64 comparisons around
    split,     ///< ParallelSplitShadowMap: each map serves a range of depths of the view
    colour,    ///< ShadowTexture: the colour is what arrives
};

// Each map is a texture unit, a matrix and a bit of a light's number.
constexpr int kMostShadowMaps = 8;

struct ShadowMaps {
    ShadowFilter filter = ShadowFilter::plain;
    std::vector<int> units;  ///< at most kMostShadowMaps; of each map

    bool empty() const { return units.empty(); }
    /// "" where there are none.
    std::string key() const;
};

struct ReceivedShadows {
    ShadowMaps maps;
    /// One for each map; null: the technique sets it after the cull.
    std::vector<osg::ref_ptr<osg::Texture>> textures;
    std::set<int> unitsTaken;  ///< those of the maps and of what belongs to them
    std::string whyNot;        ///< why there are none though the scene has shadows
};

ReceivedShadows withoutShadows(const std::string& whyNot);

ReceivedShadows shadowsOver(osgUtil::CullVisitor& visitor, const InheritedState& inherited,
                            const SceneLights& scene);

}  // namespace osgFbrdf
