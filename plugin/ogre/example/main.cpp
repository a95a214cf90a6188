// fbrdf-ogre-knot draws a torus knot of a measured material under many lights with OGRE.
//   fbrdf-ogre-knot [--lights N] [--render-system GL|GL3Plus] MATERIAL.fbrdf [PICTURE.png]
// With a second name one frame is saved, otherwise the knot turns in a window until the program is
// ended.
#include <Ogre.h>
#include <OgreShaderGenerator.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

using Ogre::RTShader::ShaderGenerator;

constexpr int kSegments = 400, kSides = 32, kMostLights = 4096;
constexpr unsigned kWidth = 640, kHeight = 480, kSamples = 4;
constexpr float kTube = 0.15f;

struct Arguments {
    int lights = 64;
    std::string renderSystem = "GL3Plus", material, picture;
};

/// False where they are not as the comment above says.
bool parse(int count, char** words, Arguments& arguments)
{
    int i = 1;
    for (; i + 1 < count && std::string(words[i]).rfind("--", 0) == 0; i += 2) {
        const std::string name = words[i], value = words[i + 1];
        if (name == "--lights") {
            arguments.lights = std::atoi(value.c_str());
            if (arguments.lights < 1 || arguments.lights > kMostLights) return false;
        } else if (name == "--render-system" && (value == "GL" || value == "GL3Plus")) {
            arguments.renderSystem = value;
        } else {
            return false;
        }
    }
    if (i < count) arguments.material = words[i];
    if (i + 1 < count) arguments.picture = words[i + 1];
    return i < count && i + 2 >= count;
}

/// The centre line of the (2, 5) torus knot.
Ogre::Vector3 centreLine(float u)
{
    const float r = 1.0f + 0.4f * std::cos(5.0f * u);
    return {r * std::cos(2.0f * u), r * std::sin(2.0f * u), 0.4f * std::sin(5.0f * u)};
}

void addRing(Ogre::ManualObject& knot, float u)
{
    const Ogre::Vector3 along = (centreLine(u + 1e-3f) - centreLine(u - 1e-3f)).normalisedCopy(),
                        side = along.crossProduct(Ogre::Vector3::UNIT_Z).normalisedCopy(),
                        up = side.crossProduct(along);
    for (int j = 0; j <= kSides; ++j) {
        const float a = Ogre::Math::TWO_PI * static_cast<float>(j) / kSides;
        const Ogre::Vector3 normal = side * std::cos(a) + up * std::sin(a);
        knot.position(centreLine(u) + normal * kTube);
        knot.normal(normal);
        knot.tangent(along);
    }
}

Ogre::ManualObject* knotOf(Ogre::SceneManager& scene, const std::string& material)
{
    Ogre::ManualObject* knot = scene.createManualObject("knot");
    knot->begin(material, Ogre::RenderOperation::OT_TRIANGLE_LIST, "General");
    for (int i = 0; i <= kSegments; ++i)
        addRing(*knot, Ogre::Math::TWO_PI * static_cast<float>(i) / kSegments);
    for (Ogre::uint32 i = 0; i < kSegments; ++i)
        for (Ogre::uint32 j = 0; j < kSides; ++j) {
            const Ogre::uint32 a = i * (kSides + 1) + j, b = a + kSides + 1;
            knot->quad(a, b, b + 1, a + 1);
        }
    knot->end();
    return knot;
}

/// Lights spread evenly over a sphere (golden angle), in many hues, of which every eighth is
/// strong. Together they are as bright whatever their number.
void addLights(Ogre::SceneManager& scene, int count)
{
    for (int i = 0; i < count; ++i) {
        const float z = 1.0f - (2.0f * static_cast<float>(i) + 1.0f) / static_cast<float>(count),
                    r = std::sqrt(1.0f - z * z), phi = static_cast<float>(i) * 2.3999632f;
        Ogre::Light* light = scene.createLight();
        light->setType(Ogre::Light::LT_POINT);
        Ogre::ColourValue hue;
        hue.setHSB(static_cast<float>(i % 7) / 7.0f, 0.1f, 1.0f);
        light->setDiffuseColour(hue);
        light->setPowerScale((i % 8 == 0 ? 160.0f : 4.0f) / static_cast<float>(count));
        light->setAttenuation(100.0f, 0.0f, 0.0f, 1.0f);  // 1 / r^2
        scene.getRootSceneNode()
            ->createChildSceneNode(4.0f * Ogre::Vector3(r * std::cos(phi), r * std::sin(phi), z))
            ->attachObject(light);
    }
}

void loadPlugins(Ogre::Root& root, const std::string& renderSystem)
{
    root.loadPlugin(FBRDF_OGRE_PLUGINS "/RenderSystem_" + renderSystem);
    root.loadPlugin(FBRDF_OGRE_PLUGINS "/Codec_STBI");
    root.loadPlugin(FBRDF_OGRE_PLUGIN);
}

void addResources(const std::string& folder)
{
    auto& groups = Ogre::ResourceGroupManager::getSingleton();
    for (const char* part : {"ShadowVolume", "RTShaderLib/materials", "RTShaderLib/GLSL"})
        groups.addResourceLocation(std::string(FBRDF_OGRE_MEDIA "/") + part, "FileSystem",
                                   Ogre::RGN_INTERNAL);
    groups.addResourceLocation(folder, "FileSystem", "General");
    groups.initialiseAllResourceGroups();
}

/// A material of OGRE with the .fbrdf in it: what docs/ogre.md shows.
void addMaterial(const std::string& file)
{
    const Ogre::MaterialPtr gold = Ogre::MaterialManager::getSingleton().create("gold", "General");
    ShaderGenerator& generator = ShaderGenerator::getSingleton();
    const Ogre::String scheme = ShaderGenerator::DEFAULT_SCHEME_NAME;
    generator.createShaderBasedTechnique(gold->getTechnique(0), scheme);
    Ogre::RTShader::SubRenderState* state = generator.createSubRenderState("Fbrdf");
    state->setParameter("material", file);
    state->setParameter("transfer", "tone-map");
    generator.getRenderState(scheme, "gold", "General", 0)->addTemplateSubRenderState(state);
}

void show(Ogre::RenderTarget& target, Ogre::Camera& camera)
{
    Ogre::Viewport* view = target.addViewport(&camera);
    view->setMaterialScheme(ShaderGenerator::DEFAULT_SCHEME_NAME);
    view->setBackgroundColour(Ogre::ColourValue(0.035f, 0.035f, 0.04f));
}

/// Draws one frame with four samples a pixel into a texture: not every window has them.
void savePicture(Ogre::Camera& camera, const std::string& file)
{
    const Ogre::TexturePtr texture = Ogre::TextureManager::getSingleton().createManual(
        "picture", "General", Ogre::TEX_TYPE_2D, kWidth, kHeight, 0, Ogre::PF_BYTE_RGB,
        Ogre::TU_RENDERTARGET, nullptr, false, kSamples);
    Ogre::RenderTarget* target = texture->getBuffer()->getRenderTarget();
    show(*target, camera);
    target->update();
    target->writeContentsToFile(file);
}

void run(const Arguments& arguments)
{
    Ogre::Root root("", "", "");
    loadPlugins(root, arguments.renderSystem);
    root.setRenderSystem(root.getAvailableRenderers().front());
    root.initialise(false);
    const Ogre::NameValuePairList window{{"FSAA", std::to_string(kSamples)}};
    Ogre::RenderWindow* target = root.createRenderWindow("fbrdf", kWidth, kHeight, false, &window);
    ShaderGenerator::initialize();
    std::string name, folder;
    Ogre::StringUtil::splitFilename(arguments.material, name, folder);
    addResources(folder.empty() ? "." : folder);
    Ogre::SceneManager* scene = root.createSceneManager();
    ShaderGenerator::getSingleton().addSceneManager(scene);
    addMaterial(name);
    addLights(*scene, arguments.lights);
    Ogre::SceneNode* node = scene->getRootSceneNode()->createChildSceneNode();
    node->attachObject(knotOf(*scene, "gold"));
    Ogre::Camera* camera = scene->createCamera("camera");
    camera->setNearClipDistance(0.1f);
    camera->setAutoAspectRatio(true);
    scene->getRootSceneNode()
        ->createChildSceneNode(Ogre::Vector3(0.0f, 0.0f, 4.5f))
        ->attachObject(camera);
    if (arguments.picture.empty()) {
        show(*target, *camera);
        while (!target->isClosed()) {
            root.renderOneFrame();
            node->yaw(Ogre::Degree(0.5f));
        }
    } else {
        savePicture(*camera, arguments.picture);
    }
    ShaderGenerator::destroy();
}

}  // namespace

int main(int count, char** words)
try {
    Arguments arguments;
    if (!parse(count, words, arguments)) {
        std::fprintf(stderr,
                     "usage: fbrdf-ogre-knot [--lights 1..%d] [--render-system GL|GL3Plus] "
                     "MATERIAL.fbrdf [PICTURE.png]\n",
                     kMostLights);
        return 2;
    }
    run(arguments);
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
