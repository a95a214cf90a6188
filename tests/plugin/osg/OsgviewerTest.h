// OsgviewerTest.h - scenes in files for the real osgviewer, and what it must show of them.
#pragma once
#include "Osgviewer.h"

#include <string>
#include <vector>

namespace fbrdf::test {

// Of 160 x 160; two spheres cover some 8,000.
constexpr size_t kEnoughPixels = 3000;
// Depth and edges are rounded elsewhere: by the X server's driver and by the surfaceless one.
constexpr size_t kEdges = 50;

/// A folder with materials noise0.fbrdf (a product) and noise4.fbrdf (a sum). Skips where a program
/// is missing; with CI=true in the environment that fails.
class OsgviewerTest : public OsgTest {
protected:
    void SetUp() override;

    std::string path(const std::string& name) const { return folder_.file(name); }
    /// Writes the scene, 64 lights added, and says where.
    std::string written(osg::Group* root);
    osg::ref_ptr<osg::Node> read(const std::string& scene);
    /// `technique` of a sphere; two look-ups make 65 passes and more.
    osg::ref_ptr<osgFbrdf::FactorizedBrdf> ball(int kind, int technique = osgFbrdf::kTwoLookups);
    /// The screen is that of the twin, but for so many pixels. With FBRDF_KEEP_SCREENS both are
    /// saved to what that begins with and `name`.
    void expectSame(const Osgviewer& viewer, ViewerTwin& twin, const std::string& name,
                    size_t pixels = kEdges);

private:
    TemporaryDir folder_;
};

osg::ref_ptr<osg::Group> groupOf(const std::vector<osg::ref_ptr<osg::Node>>& nodes);

/// Ends it. Fallbacks and OpenGL's errors would have been said; the latter are only seen then, as
/// they wait in the buffer of a stream.
void expectGoodEnd(Osgviewer& viewer);

}  // namespace fbrdf::test
