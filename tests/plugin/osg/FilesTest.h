// FilesTest.h - a folder with a material, scenes of it, and the programs that a user would run.
#pragma once
#include "OsgScene.h"

#include "support/gl/Scenes.h"
#include "support/TemporaryDir.h"

#include <fbrdf/io/MaterialFile.h>

#include <osg/MatrixTransform>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace fbrdf::test {

/// A folder with a material file, and programs run in it.
class FilesTest : public OsgTest {
protected:
    void SetUp() override
    {
        OsgTest::SetUp();
        writeMaterial(material_, path("noise.fbrdf"));
    }

    std::string path(const std::string& name) const { return folder_.file(name); }

    /// The picture of a scene of the files.
    std::vector<float> imageOf(osg::Node* node)
    {
        OsgView view(context().loader());
        view.setView(perspectiveView());
        osg::ref_ptr<osg::Group> root = new osg::Group;
        root->addChild(node);
        root->addChild(osgLights(testLights(9)));
        view.setScene(root);
        return view.frame();
    }

    osg::ref_ptr<osg::Group> scene() const
    {
        osg::ref_ptr<osgFbrdf::FactorizedBrdf> effect = new osgFbrdf::FactorizedBrdf;
        effect->setMaterialFile(path("noise.fbrdf"));
        effect->setExposure(1.5f);
        effect->setLightsPerPass(3);
        effect->setLookupsPerPass(7);
        effect->setFirstTextureUnit(2);
        effect->setFloatTarget(true);
        effect->selectTechnique(osgFbrdf::kBatched);
        effect->setTransfer(Transfer::srgb);
        effect->setReloading(true);
        effect->addChild(osgMesh(sphereMesh(12)));
        osg::ref_ptr<osg::MatrixTransform> root =
            new osg::MatrixTransform(osg::Matrixd::rotate(0.3, 0.0, 1.0, 0.0));
        root->addChild(effect);
        root->addChild(osgLights(testLights(64)));
        return root;
    }

    /// Runs a program that knows the plugins by OSG_LIBRARY_PATH and nothing else.
    std::string run(const std::string& command) const
    {
        return runWith(FBRDF_OSG_LIBRARY_PATH, command);
    }
    std::string runWith(const std::string& libraryPath, const std::string& command) const
    {
        const std::string whole =
            "env -u LD_LIBRARY_PATH " FBRDF_OSG_ENVIRONMENT "OSG_LIBRARY_PATH=" + libraryPath +
            " " + command + " >" + path("log") + " 2>&1";
        status_ = std::system(whole.c_str());
        std::ostringstream text;
        text << std::ifstream(path("log")).rdbuf();
        return text.str();
    }

    Material material_ = testMaterials()[2];
    mutable int status_ = 0;

private:
    TemporaryDir folder_;
};

}  // namespace fbrdf::test
