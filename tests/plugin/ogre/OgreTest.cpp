#include "OgreTest.h"

#include "support/gl/Gl.h"

#include <fbrdf/headless/Offscreen.h>
#include <fbrdf/io/MaterialFile.h>

namespace fbrdf::test {

void OgreTest::start(bool isLate)
{
    server_ = std::make_unique<XServer>();
    host_ = std::make_unique<OgreHost>(GetParam(), folder(), kOgrePicture, isLate);
    gl = loadGl(OgreHost::load);
    while (gl.GetError() != GL_NO_ERROR) {
    }  // those of OGRE's start are not ours
}

void OgreTest::TearDown()
{
    if (!host_) return;
    EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
    for (const std::string& line : takeLog()) ADD_FAILURE() << line;
    host_.reset();
    server_.reset();
}

void OgreTest::addMaterial(const std::string& name, const Material& material,
                           const std::string& options)
{
    writeMaterial(material, file(name + ".fbrdf"));
    addScriptOf(name, options);
}

void OgreTest::addScriptOf(const std::string& name, const std::string& options)
{
    // OGRE lists the files of a folder when it is added.
    auto& groups = Ogre::ResourceGroupManager::getSingleton();
    groups.removeResourceLocation(folder(), "General");
    groups.addResourceLocation(folder(), "FileSystem", "General");
    host_->addScript("material " + name +
                     "\n{\n technique\n {\n  pass\n  {\n   rtshader_system\n   {\n    fbrdf " +
                     name + ".fbrdf " + options + "\n   }\n  }\n }\n}\n");
}

std::vector<std::string> OgreTest::takeLog()
{
    return host_->log().take();
}

std::vector<float> OgreTest::runtimePicture(const Material& material, const gl::MeshData& mesh,
                                            const std::vector<Light>& lights, const gl::View& view,
                                            const glm::mat4& model, uint32_t normalMap)
{
    gl::RendererOptions options;
    options.load = OgreHost::load;
    gl::Renderer renderer(options);
    const auto gpuMaterial = renderer.createMaterial(material);
    const auto gpuMesh = renderer.createMesh(mesh);
    OffscreenOptions size;
    size.width = size.height = kOgrePicture;
    Offscreen offscreen(OgreHost::load, size);
    offscreen.clear();
    gl::Target target;
    target.framebuffer = offscreen.framebuffer();
    target.width = target.height = kOgrePicture;
    gl::Item item;
    item.material = gpuMaterial.get();
    item.mesh = gpuMesh.get();
    item.model = model;
    item.normalMap = normalMap;
    renderer.draw(target, view, {item}, lights);
    return offscreen.readPixels();
}

std::string programOf(const Ogre::Entity& entity)
{
    for (const Ogre::Technique* technique :
         entity.getSubEntity(0)->getMaterial()->getSupportedTechniques())
        if (technique->getSchemeName() == Ogre::RTShader::ShaderGenerator::DEFAULT_SCHEME_NAME)
            return technique->getPass(0)->getFragmentProgramName();
    return "";
}

std::vector<Light> unlimitedLights(int count)
{
    std::vector<Light> lights = testLights(count);
    for (Light& light : lights) light.radius = 0.0f;
    return lights;
}

}  // namespace fbrdf::test
