// fbrdf-osg-knot draws a torus knot of a measured material under many lights with OpenSceneGraph.
//   fbrdf-osg-knot [--lights N] [--area-lights] [--environment PICTURE.hdr|studio|overcast|clear]
//                  [--shadows] [--above PLATE.fbrdf LEFT.fbrdf RIGHT.fbrdf]
//                  MATERIAL.fbrdf [SCENE.osgt | PICTURE.png]
//   fbrdf-osg-knot --model MODEL.osgt
//   fbrdf-osg-knot --parts MODEL.osgt
// With a second name the scene is saved instead of shown, as a scene file or as a picture. --model
// saves the knot without a material, for osgviewer 'MODEL.osgt.[MATERIAL.fbrdf].fbrdf', and --parts
// the knot with the plate and the two balls of --above, for
// 'MODEL.osgt.[knot:MATERIAL.fbrdf,plate:MATERIAL.fbrdf].fbrdf'.
#include "PartsModel.h"

#include <osgFbrdf/AreaLights.h>
#include <osgFbrdf/EnvironmentLight.h>
#include <osgFbrdf/FactorizedBrdf.h>
#include <osgFbrdf/PointLights.h>

#include <osg/ArgumentParser>
#include <osg/Geometry>
#include <osg/LightSource>
#include <osgDB/FileNameUtils>
#include <osgDB/WriteFile>
#include <osgShadow/ShadowedScene>
#include <osgShadow/ViewDependentShadowMap>
#include <osgViewer/Viewer>

#include <array>
#include <cmath>
#include <iostream>

namespace {

constexpr int kSegments = 400, kSides = 32, kLights = 200, kMostLights = 100000;
constexpr float kTube = 0.3f;

/// The centre line of the (2, 5) torus knot about the y axis, along which OSG's viewers look first.
osg::Vec3f centreLine(double u)
{
    const double r = 1.0 + 0.4 * std::cos(5.0 * u);
    return {static_cast<float>(r * std::cos(2.0 * u)), static_cast<float>(-0.4 * std::sin(5.0 * u)),
            static_cast<float>(r * std::sin(2.0 * u))};
}

void addRing(osg::Geometry& knot, double u)
{
    auto& positions = static_cast<osg::Vec3Array&>(*knot.getVertexArray());
    auto& normals = static_cast<osg::Vec3Array&>(*knot.getNormalArray());
    auto& tangents =
        static_cast<osg::Vec3Array&>(*knot.getVertexAttribArray(osgFbrdf::kTangentAttribute));
    osg::Vec3f along = centreLine(u + 1e-3) - centreLine(u - 1e-3);
    along.normalize();
    osg::Vec3f side = along ^ osg::Vec3f(0.0f, 1.0f, 0.0f);
    side.normalize();
    const osg::Vec3f up = side ^ along;
    for (int j = 0; j <= kSides; ++j) {
        const double a = 2.0 * osg::PI * j / kSides;
        const osg::Vec3f normal =
            side * static_cast<float>(std::cos(a)) + up * static_cast<float>(std::sin(a));
        positions.push_back(centreLine(u) + normal * (0.5f * kTube));
        normals.push_back(normal);
        tangents.push_back(along);
    }
}

osg::ref_ptr<osg::Geometry> knotOf()
{
    osg::ref_ptr<osg::Geometry> knot = new osg::Geometry;
    knot->setVertexArray(new osg::Vec3Array);
    knot->setNormalArray(new osg::Vec3Array, osg::Array::BIND_PER_VERTEX);
    knot->setVertexAttribArray(osgFbrdf::kTangentAttribute, new osg::Vec3Array,
                               osg::Array::BIND_PER_VERTEX);
    for (int i = 0; i <= kSegments; ++i) addRing(*knot, 2.0 * osg::PI * i / kSegments);
    osg::ref_ptr<osg::DrawElementsUInt> triangles = new osg::DrawElementsUInt(GL_TRIANGLES);
    for (unsigned int i = 0; i < kSegments; ++i)
        for (unsigned int j = 0; j < kSides; ++j) {
            const unsigned int a = i * (kSides + 1) + j, b = a + kSides + 1;
            for (const unsigned int index : {a, b, b + 1, a, b + 1, a + 1})
                triangles->push_back(index);
        }
    knot->addPrimitiveSet(triangles);
    return knot;
}

/// Lights spread evenly over a sphere (golden angle), in many hues, of which every eighth is
/// strong. Together they are as bright whatever their number.
osg::ref_ptr<osgFbrdf::PointLights> lightsAround(int count)
{
    osg::ref_ptr<osgFbrdf::PointLights> lights = new osgFbrdf::PointLights;
    for (int i = 0; i < count; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / count, r = std::sqrt(1.0 - z * z),
                     phi = i * osg::PI * (3.0 - std::sqrt(5.0));
        const double size = (i % 8 == 0 ? 200.0 : 5.0) / count;
        const auto hue = [phi, size](double offset) {
            return static_cast<float>(size * (1.0 + 0.1 * std::cos(phi + offset)));
        };
        lights->addPoint(osg::Vec3f(static_cast<float>(r * std::cos(phi)),
                                    static_cast<float>(r * std::sin(phi)), static_cast<float>(z)) *
                             4.0f,
                         {hue(0.0), hue(2.1), hue(4.2)});
    }
    return lights;
}

/// A soft box above, a tube on the left and a sphere on the right.
osg::ref_ptr<osgFbrdf::AreaLights> areaLights()
{
    osg::ref_ptr<osgFbrdf::AreaLights> lights = new osgFbrdf::AreaLights;
    fbrdf::AreaLight box, tube, sphere;
    box.shape = fbrdf::AreaLight::Shape::rectangle;
    box.position = {0.0f, -1.5f, 3.0f};
    box.axisU = {0.0f, 1.0f, 0.5f};
    box.axisV = {1.5f, 0.0f, 0.0f};
    box.radiance = {4.0f, 4.0f, 4.0f};
    tube.shape = fbrdf::AreaLight::Shape::tube;
    tube.position = {-3.0f, -1.5f, -1.0f};
    tube.end = {-2.0f, -2.0f, 1.5f};
    tube.size = 0.15f;
    tube.radiance = {4.0f, 8.0f, 12.0f};
    sphere.position = {3.0f, -1.0f, 0.5f};
    sphere.radiance = {12.0f, 8.0f, 4.0f};
    for (const fbrdf::AreaLight& light : {box, tube, sphere}) lights->addLight(light);
    return lights;
}

/// One of OpenGL's lights, which falls off by 1 / r^2.
osg::ref_ptr<osg::LightSource> lamp(unsigned int number, const osg::Vec3f& place,
                                    const osg::Vec3f& colour)
{
    osg::ref_ptr<osg::Light> light = new osg::Light(number);
    light->setPosition(osg::Vec4f(place, 1.0f));
    light->setDirection(-place);
    light->setAmbient({0.0f, 0.0f, 0.0f, 1.0f});
    light->setDiffuse(osg::Vec4f(colour, 1.0f));
    light->setConstantAttenuation(0.0f);
    light->setQuadraticAttenuation(1.0f);
    osg::ref_ptr<osg::LightSource> source = new osg::LightSource;
    source->setLight(light);
    return source;
}

/// The effect with a floor below its model, under two lamps that cast shadows and a faint light
/// from the viewer that casts none.
osg::ref_ptr<osg::Group> withShadows(osgFbrdf::FactorizedBrdf* effect)
{
    const osg::ref_ptr<osg::Geometry> floor = osg::createTexturedQuadGeometry(
        {-6.0f, -6.0f, -1.7f}, {12.0f, 0.0f, 0.0f}, {0.0f, 12.0f, 0.0f});
    effect->addChild(floor);
    // The maps have the back faces of models that have these culled: fewer stripes on the fronts.
    for (unsigned int i = 0; i < effect->getNumChildren(); ++i)
        effect->getChild(i)->getOrCreateStateSet()->setMode(GL_CULL_FACE, osg::StateAttribute::ON);
    osg::ref_ptr<osgShadow::ShadowedScene> scene =
        new osgShadow::ShadowedScene(new osgShadow::ViewDependentShadowMap);
    scene->getShadowSettings()->setTextureSize({2048, 2048});
    scene->addChild(lamp(0, {4.0f, -3.0f, 6.0f}, {90.0f, 80.0f, 65.0f}));
    scene->addChild(lamp(1, {-5.0f, -2.5f, 4.5f}, {18.0f, 27.0f, 40.0f}));
    osg::ref_ptr<osgFbrdf::PointLights> fill = new osgFbrdf::PointLights;
    fill->addDirectional({0.0f, -1.0f, 0.5f}, {0.2f, 0.2f, 0.2f});
    scene->addChild(fill);
    scene->addChild(effect);
    return scene;
}

/// Puts the knot above a plate with two balls, which have materials of their own; false where one
/// cannot be read.
bool addParts(osgFbrdf::FactorizedBrdf& effect, const std::array<std::string, 3>& files)
{
    effect.addChild(partsModel(knotOf()));
    osgFbrdf::ModelTextures textures;
    textures.tint = 0;  // the fields of the plate
    effect.setModelTextures(textures);
    const std::array<const char*, 3> names{"plate", "ball left", "ball right"};
    for (size_t i = 0; i < names.size(); ++i)
        if (!effect.setPartMaterialFile(names[i], files[i])) return false;
    return true;
}

/// Keeps the picture that a camera has drawn.
class Keep : public osg::Camera::DrawCallback {
public:
    void operator()(osg::RenderInfo& info) const override
    {
        const osg::Viewport& view = *info.getCurrentCamera()->getViewport();
        picture->readPixels(0, 0, static_cast<int>(view.width()), static_cast<int>(view.height()),
                            GL_RGB, GL_UNSIGNED_BYTE);
    }
    osg::ref_ptr<osg::Image> picture = new osg::Image;
};

/// raised: the plate is below, and the camera looks down at it.
bool savePicture(osg::Node& scene, const std::string& file, bool raised)
{
    osgViewer::Viewer viewer;
    viewer.setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
    viewer.setUpViewInWindow(0, 0, 640, 480);
    viewer.setSceneData(&scene);
    viewer.getCamera()->setClearColor({0.04f, 0.04f, 0.05f, 1.0f});
    const osg::Vec3d eye(0.0, raised ? -7.2 : -6.2, raised ? 2.0 : 1.6);
    viewer.getCamera()->setViewMatrixAsLookAt(eye, {0.0, 0.0, raised ? -0.35 : 0.0},
                                              {0.0, 0.0, 1.0});
    const osg::ref_ptr<Keep> keep = new Keep;
    viewer.getCamera()->setFinalDrawCallback(keep);
    for (int i = 0; i < 2; ++i) viewer.frame();
    return osgDB::writeImageFile(*keep->picture, file);
}

int usage()
{
    std::cerr << "usage: fbrdf-osg-knot [--lights N] [--area-lights]\n"
                 "                      [--environment PICTURE|studio|overcast|clear] [--shadows]\n"
                 "                      [--above PLATE.fbrdf LEFT.fbrdf RIGHT.fbrdf]\n"
                 "                      MATERIAL.fbrdf [SCENE.osgt | PICTURE.png]\n"
                 "       fbrdf-osg-knot --model MODEL.osgt\n"
                 "       fbrdf-osg-knot --parts MODEL.osgt\n";
    return 2;
}

}  // namespace

int main(int argc, char** argv)
{
    osg::ArgumentParser arguments(&argc, argv);
    int lightCount = kLights;
    std::string model, parts, environment;
    // Where an environment or area lights light the knot there are no others, unless asked for.
    const bool hasAreaLights = arguments.read("--area-lights");
    const bool hasShadows = arguments.read("--shadows");
    std::array<std::string, 3> below;
    const bool hasParts = arguments.read("--above", below[0], below[1], below[2]);
    if (arguments.read("--environment", environment) || hasAreaLights || hasShadows) lightCount = 0;
    const bool mayBeWithout = lightCount == 0;
    arguments.read("--lights", lightCount);
    arguments.read("--model", model);
    arguments.read("--parts", parts);
    const int asked = (argc > 1 ? 1 : 0) + (model.empty() ? 0 : 1) + (parts.empty() ? 0 : 1);
    if (arguments.errors() || arguments.containsOptions() || lightCount < (mayBeWithout ? 0 : 1) ||
        lightCount > kMostLights || argc > 3 || asked != 1)
        return usage();
    if (!model.empty()) return osgDB::writeNodeFile(*knotOf(), model) ? 0 : 5;
    if (!parts.empty()) return osgDB::writeNodeFile(*partsModel(knotOf()), parts) ? 0 : 5;
    // 1. The material over the model.
    osg::ref_ptr<osgFbrdf::FactorizedBrdf> effect = new osgFbrdf::FactorizedBrdf;
    if (!effect->setMaterialFile(argv[1])) return 3;
    effect->setTransfer(fbrdf::Transfer::toneMap);  // for a window, which shows sRGB codes
    effect->setExposure(mayBeWithout ? 1.0f : 2.5f);
    if (!hasParts) effect->addChild(knotOf());
    if (hasParts && !addParts(*effect, below)) return 3;
    // 2. The lights, anywhere in the scene.
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    if (hasShadows)
        scene->addChild(withShadows(effect));
    else
        scene->addChild(effect);
    if (lightCount > 0) scene->addChild(lightsAround(lightCount));
    if (hasAreaLights) scene->addChild(areaLights());
    if (!environment.empty()) {
        osg::ref_ptr<osgFbrdf::EnvironmentLight> light = new osgFbrdf::EnvironmentLight;
        if (!light->setPictureFile(environment)) return 3;
        scene->addChild(light);
    }
    // 3. The scene is saved or shown.
    if (argc == 3 && osgDB::getLowerCaseFileExtension(argv[2]) == "png")
        return savePicture(*scene, argv[2], hasParts) ? 0 : 5;
    if (argc == 3) return osgDB::writeNodeFile(*scene, argv[2]) ? 0 : 5;
    osgViewer::Viewer viewer;
    viewer.setSceneData(scene);
    viewer.realize();
    return viewer.isRealized() ? viewer.run() : 6;  // 6: no display
}
