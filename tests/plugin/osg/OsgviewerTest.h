// OsgviewerTest.h - makes files of scenes for the real osgviewer and checks what it shows of them.
#pragma once
#include "Osgviewer.h"

#include <string>
#include <vector>

namespace fbrdf::test {

// The screen has 160 x 160 pixels, of which two spheres cover some 8,000.
constexpr size_t kEnoughPixels = 3000;
// The driver of the X server and the one without a surface round depths and edges differently.
constexpr size_t kEdges = 50;

/// A folder with materials noise0.fbrdf (a product) and noise4.fbrdf (a sum). Skips where a program
/// is missing; with CI=true in the environment that fails.
class OsgviewerTest : public OsgTest {
protected:
    void SetUp() override;

    std::string path(const std::string& name) const { return folder_.file(name); }
    /// Writes the scene with 64 lights added; returns the name of the file.
    std::string written(osg::Group* root);
    osg::ref_ptr<osg::Node> read(const std::string& scene);
    /// A sphere drawn by `technique`; two look-ups a pass make 65 passes and more.
    osg::ref_ptr<osgFbrdf::FactorizedBrdf> ball(int kind, int technique = osgFbrdf::kTwoLookups);
    /// Expects the screen to equal that of the twin but for so many pixels. With FBRDF_KEEP_SCREENS
    /// in the environment both are saved under that prefix and `name`.
    void expectSame(const Osgviewer& viewer, ViewerTwin& twin, const std::string& name,
                    size_t pixels = kEdges);

private:
    TemporaryDir folder_;
};

osg::ref_ptr<osg::Group> groupOf(const std::vector<osg::ref_ptr<osg::Node>>& nodes);

/// Ends the program, and expects no message of a fallback or of OpenGL's errors; the latter are
/// only seen at the end, as they wait in the buffer of a stream.
void expectGoodEnd(Osgviewer& viewer);

}  // namespace fbrdf::test
