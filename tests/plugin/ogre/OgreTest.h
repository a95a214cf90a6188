// OgreTest.h - the fixture of tests that draw with OGRE, once for each render system.
#pragma once
#include "OgreHost.h"
#include "XServer.h"

#include "support/gl/CompareImages.h"
#include "support/gl/Scenes.h"
#include "support/TemporaryDir.h"

#include <gtest/gtest.h>

#include <glad/gl.h>

namespace fbrdf::test {

constexpr int kOgrePicture = 64;

class OgreTest : public ::testing::TestWithParam<const char*> {
protected:
    void SetUp() override { start(false); }
    void start(bool isLate);
    /// Fails on GL errors, and on lines of the plugin in the log that no test has taken.
    void TearDown() override;

    OgreHost& host() { return *host_; }
    std::string file(const std::string& name) const { return folder_.file(name); }
    std::string folder() const { return folder_.file("."); }
    /// Writes the material to NAME.fbrdf, and makes OGRE's material NAME with it and the options.
    void addMaterial(const std::string& name, const Material& material,
                     const std::string& options = "");
    /// Makes OGRE's material NAME with what is in NAME.fbrdf.
    void addScriptOf(const std::string& name, const std::string& options = "");
    /// The plugin's lines in the log since the last call.
    std::vector<std::string> takeLog();
    /// What the runtime draws in the same context.
    std::vector<float> runtimePicture(const Material& material, const gl::MeshData& mesh,
                                      const std::vector<Light>& lights, const gl::View& view,
                                      const glm::mat4& model = glm::mat4(1.0f),
                                      uint32_t normalMap = 0);
    GladGLContext gl{};

private:
    TemporaryDir folder_;
    std::unique_ptr<XServer> server_;
    std::unique_ptr<OgreHost> host_;
};

/// Those of testLights, without radii, which OGRE does not have.
std::vector<Light> unlimitedLights(int count);

/// The name of the fragment program that drew the entity's first part.
std::string programOf(const Ogre::Entity& entity);

inline std::string systemName(const ::testing::TestParamInfo<const char*>& info)
{
    return info.param;
}

#define FBRDF_ON_BOTH_SYSTEMS(Suite) \
    INSTANTIATE_TEST_SUITE_P(Systems, Suite, ::testing::Values("GL3Plus", "GL"), systemName)

}  // namespace fbrdf::test
