#include "OgreHost.h"

#include <dlfcn.h>

#include <cstdlib>
#include <cstring>

namespace fbrdf::test {
namespace {

using Ogre::RTShader::ShaderGenerator;

const char kGroup[] = "General";

Ogre::Matrix4 ogreMatrix(const glm::mat4& m)
{
    Ogre::Matrix4 result;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            result[static_cast<size_t>(row)][static_cast<size_t>(column)] = m[column][row];
    return result;
}

void addMedia()
{
    auto& groups = Ogre::ResourceGroupManager::getSingleton();
    for (const char* folder : {"ShadowVolume", "RTShaderLib/materials", "RTShaderLib/GLSL"})
        groups.addResourceLocation(std::string(FBRDF_OGRE_MEDIA) + "/" + folder, "FileSystem",
                                   Ogre::RGN_INTERNAL);
}

/// Of each vertex: position, normal, tangent with handedness, texture coordinates.
std::vector<float> verticesOf(const gl::MeshData& mesh)
{
    std::vector<float> vertices;
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec3f &p = mesh.positions[i], &n = mesh.normals[i];
        const Vec3f t = mesh.tangents.empty() ? Vec3f(0.0f) : mesh.tangents[i];
        const float side = mesh.handedness.empty() ? 1.0f : mesh.handedness[i];
        const glm::vec2 st =
            mesh.textureCoordinates.empty() ? glm::vec2(0.0f) : mesh.textureCoordinates[i];
        vertices.insert(vertices.end(),
                        {p.x, p.y, p.z, n.x, n.y, n.z, t.x, t.y, t.z, side, st.x, st.y});
    }
    return vertices;
}

Ogre::HardwareVertexBufferSharedPtr vertexBuffer(Ogre::VertexDeclaration& declaration,
                                                 const gl::MeshData& mesh)
{
    using Ogre::VET_FLOAT2;
    using Ogre::VET_FLOAT3;
    using Ogre::VET_FLOAT4;
    size_t offset = 0;
    offset += declaration.addElement(0, offset, VET_FLOAT3, Ogre::VES_POSITION).getSize();
    offset += declaration.addElement(0, offset, VET_FLOAT3, Ogre::VES_NORMAL).getSize();
    offset += declaration.addElement(0, offset, VET_FLOAT4, Ogre::VES_TANGENT).getSize();
    offset +=
        declaration.addElement(0, offset, VET_FLOAT2, Ogre::VES_TEXTURE_COORDINATES).getSize();
    const std::vector<float> vertices = verticesOf(mesh);
    auto buffer = Ogre::HardwareBufferManager::getSingleton().createVertexBuffer(
        offset, mesh.positions.size(), Ogre::HardwareBuffer::HBU_STATIC);
    buffer->writeData(0, vertices.size() * sizeof(float), vertices.data(), true);
    return buffer;
}

}  // namespace

void LogLines::messageLogged(const Ogre::String& message, Ogre::LogMessageLevel level, bool,
                             const Ogre::String&, bool&)
{
    const size_t start = message.find("ogreFbrdf: ");  // OGRE puts "Warning: " before it
    if (level < Ogre::LML_WARNING || start == std::string::npos) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    lines_.push_back(message.substr(start));
}

std::vector<std::string> LogLines::take()
{
    const std::lock_guard<std::mutex> lock(mutex_);
    std::vector<std::string> lines;
    lines.swap(lines_);
    return lines;
}

Ogre::Technique* MakesTechniques::handleSchemeNotFound(unsigned short, const Ogre::String& scheme,
                                                       Ogre::Material* material, unsigned short,
                                                       const Ogre::Renderable*)
{
    auto& generator = ShaderGenerator::getSingleton();
    if (scheme != ShaderGenerator::DEFAULT_SCHEME_NAME ||
        !generator.createShaderBasedTechnique(*material, Ogre::MaterialManager::DEFAULT_SCHEME_NAME,
                                              scheme))
        return nullptr;
    generator.validateMaterial(scheme, material->getName(), material->getGroup());
    material->compile();
    for (Ogre::Technique* technique : material->getSupportedTechniques())
        if (technique->getSchemeName() == scheme) return technique;
    return nullptr;
}

OgreHost::OgreHost(const std::string& renderSystem, const std::string& folder, int size,
                   bool isLate)
    : logs_(new Ogre::LogManager), size_(size)
{
    logs_->createLog(folder + "/ogre.log", true, false, false)->addListener(&lines_);
    root_ = std::make_unique<Ogre::Root>("", "", "");
    root_->loadPlugin(std::string(FBRDF_OGRE_PLUGINS) + "/RenderSystem_" + renderSystem);
    root_->loadPlugin(std::string(FBRDF_OGRE_PLUGINS) + "/Codec_STBI");
    if (!isLate) root_->loadPlugin(pluginFile());
    root_->setRenderSystem(root_->getAvailableRenderers().front());
    root_->initialise(false);
    Ogre::NameValuePairList window{{"hidden", "true"}, {"vsync", "false"}};
    root_->createRenderWindow("hidden", 16, 16, false, &window)->setAutoUpdated(false);
    addMedia();
    Ogre::ResourceGroupManager::getSingleton().addResourceLocation(folder, "FileSystem", kGroup);
    ShaderGenerator::initialize();
    Ogre::MaterialManager::getSingleton().addListener(&techniques_);
    Ogre::ResourceGroupManager::getSingleton().initialiseAllResourceGroups();
    scene_ = root_->createSceneManager();
    generator().addSceneManager(scene_);
    scene_->setAmbientLight(Ogre::ColourValue::Black);
    camera_ = scene_->createCamera("camera");
    scene_->getRootSceneNode()->createChildSceneNode()->attachObject(camera_);
    const auto side = static_cast<Ogre::uint>(size);
    target_ = Ogre::TextureManager::getSingleton().createManual(
        "target", kGroup, Ogre::TEX_TYPE_2D, side, side, 0, Ogre::PF_FLOAT32_RGBA,
        Ogre::TU_RENDERTARGET);
    Ogre::RenderTarget* target = target_->getBuffer()->getRenderTarget();
    target->setAutoUpdated(false);
    viewport_ = target->addViewport(camera_);
    viewport_->setBackgroundColour(Ogre::ColourValue(0.0f, 0.0f, 0.0f, 0.0f));
    viewport_->setOverlaysEnabled(false);
    viewport_->setMaterialScheme(ShaderGenerator::DEFAULT_SCHEME_NAME);
    if (isLate) root_->loadPlugin(pluginFile());
}

const char* OgreHost::pluginFile()
{
    const char* installed = std::getenv("FBRDF_OGRE_PLUGIN");
    return installed ? installed : FBRDF_OGRE_PLUGIN;
}

OgreHost::~OgreHost()
{
    target_.reset();
    Ogre::MaterialManager::getSingleton().removeListener(&techniques_);
    if (ShaderGenerator::getSingletonPtr()) ShaderGenerator::destroy();
    root_.reset();
    logs_->getDefaultLog()->removeListener(&lines_);
}

ShaderGenerator& OgreHost::generator()
{
    return ShaderGenerator::getSingleton();
}

Ogre::MeshPtr OgreHost::addMesh(const std::string& name, const gl::MeshData& data)
{
    Ogre::MeshPtr mesh = Ogre::MeshManager::getSingleton().createManual(name, kGroup);
    Ogre::SubMesh* part = mesh->createSubMesh();
    part->useSharedVertices = false;
    part->vertexData = new Ogre::VertexData;
    part->vertexData->vertexCount = data.positions.size();
    auto buffer = vertexBuffer(*part->vertexData->vertexDeclaration, data);
    part->vertexData->vertexBufferBinding->setBinding(0, buffer);
    part->indexData->indexCount = data.indices.size();
    part->indexData->indexBuffer = Ogre::HardwareBufferManager::getSingleton().createIndexBuffer(
        Ogre::HardwareIndexBuffer::IT_32BIT, data.indices.size(), Ogre::HardwareBuffer::HBU_STATIC);
    part->indexData->indexBuffer->writeData(0, data.indices.size() * sizeof(uint32_t),
                                            data.indices.data(), true);
    Ogre::AxisAlignedBox box;
    for (const Vec3f& p : data.positions) box.merge(Ogre::Vector3(p.x, p.y, p.z));
    mesh->_setBounds(box);
    mesh->load();
    return mesh;
}

Ogre::Entity* OgreHost::addEntity(const std::string& mesh, const std::string& material)
{
    Ogre::Entity* entity = scene_->createEntity(mesh);
    entity->setMaterialName(material, kGroup);
    scene_->getRootSceneNode()->createChildSceneNode()->attachObject(entity);
    return entity;
}

void OgreHost::addScript(const std::string& text)
{
    auto stream = std::make_shared<Ogre::MemoryDataStream>("test.material", text.size());
    std::memcpy(stream->getPtr(), text.data(), text.size());
    Ogre::DataStreamPtr data = stream;
    Ogre::MaterialManager::getSingleton().parseScript(data, kGroup);
}

void OgreHost::setView(const gl::View& view)
{
    camera_->setCustomViewMatrix(true, Ogre::Affine3(ogreMatrix(view.view)));
    camera_->setCustomProjectionMatrix(true, ogreMatrix(view.projection));
}

Ogre::Light* OgreHost::addLight(const Light& light)
{
    Ogre::Light* result = scene_->createLight();
    Ogre::SceneNode* node = scene_->getRootSceneNode()->createChildSceneNode();
    node->attachObject(result);
    const Vec3f colour = light.intensity / static_cast<float>(kPi);
    result->setDiffuseColour(colour.r, colour.g, colour.b);
    const Ogre::Vector3 position(light.position.x, light.position.y, light.position.z);
    Ogre::Vector3 direction(light.axis.x, light.axis.y, light.axis.z);
    result->setType(Ogre::Light::LT_POINT);
    if (light.type == Light::Type::directional) {
        result->setType(Ogre::Light::LT_DIRECTIONAL);
        direction = -position;
    } else {
        node->setPosition(position);
        result->setAttenuation(1000.0f, 0.0f, 0.0f, 1.0f);
    }
    if (light.type == Light::Type::spot) {
        result->setType(Ogre::Light::LT_SPOTLIGHT);
        result->setSpotlightRange(Ogre::Radian(2.0f * light.innerAngle),
                                  Ogre::Radian(2.0f * light.outerAngle), 2.0f);
    }
    node->setDirection(direction.normalisedCopy(), Ogre::Node::TS_WORLD);
    return result;
}

void OgreHost::draw()
{
    target_->getBuffer()->getRenderTarget()->update();
}

std::vector<float> OgreHost::picture()
{
    draw();
    const auto side = static_cast<Ogre::uint32>(size_);
    std::vector<float> top(4 * side * side);
    target_->getBuffer()->blitToMemory(
        Ogre::PixelBox(side, side, 1, Ogre::PF_FLOAT32_RGBA, top.data()));
    // OGRE's first row is the top one.
    std::vector<float> pixels;
    const auto row = static_cast<std::ptrdiff_t>(4 * side);
    for (auto end = top.end(); end != top.begin(); end -= row)
        pixels.insert(pixels.end(), end - row, end);
    return pixels;
}

void* OgreHost::load(void*, const char* name)
{
    using Function = void (*)();
    static const auto look = reinterpret_cast<Function (*)(const unsigned char*)>(
        dlsym(dlopen("libGL.so.1", RTLD_LAZY), "glXGetProcAddressARB"));
    return reinterpret_cast<void*>(look(reinterpret_cast<const unsigned char*>(name)));
}

}  // namespace fbrdf::test
