// A program outside the project runs the quick start of plugin/osg/README.md and saves the scene.
#include <osgFbrdf/EnvironmentLight.h>
#include <osgFbrdf/FactorizedBrdf.h>
#include <osgFbrdf/PointLights.h>

#include <fbrdf/environment/Panorama.h>
#include <fbrdf/io/MaterialFile.h>

#include <osg/Geometry>
#include <osgDB/ReadFile>
#include <osgDB/WriteFile>

#include <cstdio>

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    const std::string folder = argv[1], file = folder + "/grey.fbrdf", saved = folder + "/out.osgt";
    fbrdf::Material grey;
    grey.form = fbrdf::formHdio({4, 4, 4});
    for (const fbrdf::TableSpec& spec : grey.form.tables) {
        fbrdf::Table table;
        table.name = spec.name;
        table.domain = spec.domain;
        table.texels.assign(3 * static_cast<size_t>(fbrdf::texelCount(spec.domain)), 0.0f);
        grey.tables.push_back(fbrdf::quantized(table, fbrdf::Storage::log8));
    }
    grey.scales.emplace_back(0.5f);
    fbrdf::writeMaterial(grey, file);

    osg::ref_ptr<osg::Group> scene = new osg::Group;
    osg::ref_ptr<osg::Node> model = osg::createTexturedQuadGeometry({}, {1, 0, 0}, {0, 1, 0});
    osg::ref_ptr<osgFbrdf::FactorizedBrdf> effect = new osgFbrdf::FactorizedBrdf;
    effect->setMaterialFile(file);
    effect->addChild(model);
    osg::ref_ptr<osgFbrdf::PointLights> lights = new osgFbrdf::PointLights;
    lights->addPoint({0, 2, 3}, {40, 40, 40});
    scene->addChild(effect);
    osg::ref_ptr<osgFbrdf::EnvironmentLight> sky = new osgFbrdf::EnvironmentLight;
    if (!sky->setPanorama({2, 1, {fbrdf::Vec3f(1.0f), fbrdf::Vec3f(1.0f)}})) return 1;
    scene->addChild(lights);
    scene->addChild(sky);
    if (!effect->getMaterial() || !osgDB::writeNodeFile(*scene, saved)) return 1;
    const osg::ref_ptr<osg::Node> read = osgDB::readRefNodeFile(saved);
    const auto* again = read && read->asGroup()->getNumChildren() == 3
                            ? dynamic_cast<osgFbrdf::FactorizedBrdf*>(read->asGroup()->getChild(0))
                            : nullptr;
    std::puts(again && again->getMaterial() ? "kept" : "lost");
    return again && again->getMaterial() ? 0 : 1;
}
