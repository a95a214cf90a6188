// OgreHost.h - a program with OGRE, its shader generator and Plugin_Fbrdf, that draws to a float
// texture.
#pragma once
#include <fbrdf/gl/Renderer.h>

#include <Ogre.h>
#include <OgreRTShaderSystem.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace fbrdf::test {

/// The plugin's warnings in OGRE's log, to which threads of OGRE write too.
class LogLines : public Ogre::LogListener {
public:
    void messageLogged(const Ogre::String& message, Ogre::LogMessageLevel level, bool,
                       const Ogre::String&, bool&) override;
    /// Those since the last call.
    std::vector<std::string> take();

private:
    std::mutex mutex_;
    std::vector<std::string> lines_;
};

/// Makes a technique of the shader generator for every material that has none, as OgreBites does.
class MakesTechniques : public Ogre::MaterialManager::Listener {
public:
    Ogre::Technique* handleSchemeNotFound(unsigned short index, const Ogre::String& scheme,
                                          Ogre::Material* material, unsigned short lod,
                                          const Ogre::Renderable* renderable) override;
};

class OgreHost {
public:
    /// renderSystem: "GL" or "GL3Plus". folder: resources of the group "General". isLate: the
    /// plugin is loaded when everything else is there.
    OgreHost(const std::string& renderSystem, const std::string& folder, int size,
             bool isLate = false);
    ~OgreHost();

    Ogre::Root& root() { return *root_; }
    Ogre::SceneManager& scene() { return *scene_; }
    Ogre::Camera& camera() { return *camera_; }
    Ogre::Viewport& viewport() { return *viewport_; }
    Ogre::RTShader::ShaderGenerator& generator();
    LogLines& log() { return lines_; }
    /// As plugins.cfg names it: without ending. FBRDF_OGRE_PLUGIN in the environment is another.
    static const char* pluginFile();

    Ogre::MeshPtr addMesh(const std::string& name, const gl::MeshData& mesh);
    /// An entity at the origin. material: a name, drawn by the shader generator.
    Ogre::Entity* addEntity(const std::string& mesh, const std::string& material);
    /// A material of OGRE by a script in the syntax of .material files.
    void addScript(const std::string& text);
    void setView(const gl::View& view);
    Ogre::Light* addLight(const Light& light);

    /// Culls and draws.
    void draw();
    /// Draws. RGBA, bottom row first.
    std::vector<float> picture();
    /// Looks a GL function up in OGRE's context.
    static void* load(void* user, const char* name);

private:
    LogLines lines_;
    MakesTechniques techniques_;
    std::unique_ptr<Ogre::LogManager> logs_;
    std::unique_ptr<Ogre::Root> root_;
    Ogre::SceneManager* scene_ = nullptr;
    Ogre::Camera* camera_ = nullptr;
    Ogre::Viewport* viewport_ = nullptr;
    Ogre::TexturePtr target_;
    int size_;
};

}  // namespace fbrdf::test
