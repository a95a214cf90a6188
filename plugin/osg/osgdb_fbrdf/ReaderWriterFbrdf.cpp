// osgdb_fbrdf: materials for osgDB. FILE.fbrdf is a sphere of that material, or the material itself
// where osgFbrdf::readMaterialObject() asks; MODEL.EXT.[FILE].fbrdf is MODEL.EXT drawn with it, and
// MODEL.EXT.[PART:FILE,PART:FILE].fbrdf with a material for each part.
// SCENE.EXT.fbrdf, where that is no material, writes SCENE.EXT in the plain form
// (osgFbrdf/PlainForm.h) and reads it back. What is written to FILE.fbrdf and to streams is the
// material of an object, or the one material of a scene.
#include "Arguments.h"
#include "MaterialOf.h"
#include "MaterialsInUse.h"
#include "Sphere.h"

#include <osgFbrdf/EnvironmentLight.h>
#include <osgFbrdf/FactorizedBrdf.h>
#include <osgFbrdf/PlainForm.h>

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/io/MaterialFile.h>

#include <osg/Notify>
#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>
#include <osgDB/ReadFile>
#include <osgDB/Registry>

#include <iterator>

namespace osgFbrdf {
namespace {

class ReaderWriterFbrdf : public osgDB::ReaderWriter {
public:
    ReaderWriterFbrdf()
    {
        supportsExtension(
            "fbrdf",
            "Factored BRDF, read and written; MODEL.EXT.[FILE.fbrdf].fbrdf is a model with it, "
            "MODEL.EXT.[PART:FILE.fbrdf,PART:FILE.fbrdf].fbrdf one with parts of several; "
            "SCENE.EXT.fbrdf writes and reads SCENE.EXT for readers without osgFbrdf");
        for (const OptionText& option : optionTexts()) supportsOption(option.name, option.text);
    }

    const char* className() const override { return "Factored BRDF reader"; }

    ReadResult readObject(const std::string& file, const Options* options) const override
    {
        const std::string how = options ? options->getPluginStringData(kReadMaterial) : "";
        return how.empty() ? readNode(file, options) : readMaterialFile(file, options, how);
    }

    ReadResult readNode(const std::string& file, const Options* options) const override
    {
        if (!acceptsExtension(osgDB::getLowerCaseFileExtension(file)))
            return ReadResult::FILE_NOT_HANDLED;
        const PseudoName name = pseudoName(file);
        if (!name.model.empty()) return readModel(name, options);
        if (osgDB::findDataFile(file, options).empty() && !plainName(file).empty())
            return readPlain(plainName(file), options);
        ReadResult read = readMaterialFile(file, options, kShared);
        auto* material = dynamic_cast<MaterialObject*>(read.getObject());
        if (!material) return read;
        osg::ref_ptr<FactorizedBrdf> effect = newEffect(options);
        effect->setMaterial(material, options);
        effect->addChild(unitSphere());
        return lit(effect, options).get();
    }

    /// The bytes of a .fbrdf, as a scene file has them.
    ReadResult readObject(std::istream& stream, const Options*) const override
    {
        try {
            const std::string bytes(std::istreambuf_iterator<char>(stream), {});
            return new MaterialObject(fbrdf::materialFromFileBytes(bytes, "material in a stream"));
        } catch (const fbrdf::Error& error) {
            return ReadResult(std::string(error.what()));
        }
    }

    ReadResult readNode(std::istream& stream, const Options* options) const override
    {
        ReadResult read = readObject(stream, options);
        auto* material = dynamic_cast<MaterialObject*>(read.getObject());
        if (!material) return read;
        osg::ref_ptr<FactorizedBrdf> effect = newEffect(options);
        effect->setMaterial(material);
        effect->addChild(unitSphere());
        return lit(effect, options).get();
    }

    WriteResult writeObject(const osg::Object& object, const std::string& file,
                            const Options* options) const override
    {
        const auto* node = dynamic_cast<const osg::Node*>(&object);
        if (node) return writeNode(*node, file, options);
        if (!acceptsExtension(osgDB::getLowerCaseFileExtension(file)))
            return WriteResult::FILE_NOT_HANDLED;
        return writeMaterialOf(object, file);
    }

    WriteResult writeNode(const osg::Node& node, const std::string& file,
                          const Options* options) const override
    {
        if (!acceptsExtension(osgDB::getLowerCaseFileExtension(file)))
            return WriteResult::FILE_NOT_HANDLED;
        const std::string plain = plainName(file);
        if (plain.empty()) return writeMaterialOf(node, file);
        return osgDB::Registry::instance()->writeNode(*plainForm(node), plain, options);
    }

    WriteResult writeObject(const osg::Object& object, std::ostream& stream,
                            const Options*) const override
    {
        return written(object, "stream", [&stream](const fbrdf::Material& material) {
            if (!(stream << fbrdf::materialFileBytes(material)))
                throw fbrdf::Error(fbrdf::ErrorKind::output, "stream", "cannot be written");
        });
    }

    WriteResult writeNode(const osg::Node& node, std::ostream& stream,
                          const Options* options) const override
    {
        return writeObject(node, stream, options);
    }

private:
    static WriteResult writeMaterialOf(const osg::Object& object, const std::string& file)
    {
        return written(object, file, [&file](const fbrdf::Material& material) {
            fbrdf::writeMaterial(material, file);
        });
    }

    /// Calls write with the material of the object, and returns what became of it.
    template <class Write>
    static WriteResult written(const osg::Object& object, const std::string& where, Write write)
    {
        std::string problem;
        const auto material = materialOf(object, problem);
        if (!material) return WriteResult(where + ": " + problem);
        try {
            write(material->material());
        } catch (const fbrdf::Error& error) {
            return WriteResult(std::string(error.what()));
        }
        return WriteResult::FILE_SAVED;
    }

    /// how: kShared or kAnew.
    ReadResult readMaterialFile(const std::string& file, const Options* options,
                                const std::string& how) const
    {
        const std::string path = osgDB::findDataFile(file, options);
        if (path.empty()) return notFound(file);
        // The key is made before the file is read: one that changes meanwhile is read again.
        const MaterialsInUse::Key key = MaterialsInUse::keyOf(file, path);
        const auto known = how == kAnew ? nullptr : inUse_.find(key);
        if (known) return known.get();
        if (!fbrdf::isMaterialFile(path)) return ReadResult::FILE_NOT_HANDLED;
        try {
            const osg::ref_ptr<MaterialObject> material =
                new MaterialObject(fbrdf::readMaterial(path), file);
            inUse_.add(key, *material);
            return material.get();
        } catch (const fbrdf::Error& error) {
            return ReadResult(std::string(error.what()));
        }
    }

    static ReadResult readPlain(const std::string& name, const Options* options)
    {
        const std::string path = osgDB::findDataFile(name, options);
        if (path.empty()) return notFound(name + ".fbrdf");
        const osg::ref_ptr<Options> local = besides(path, options);
        const osg::ref_ptr<osg::Node> scene = osgDB::readRefNodeFile(path, local);
        if (!scene)
            return ReadResult(name + ": " +
                              fbrdf::Found("no scene that can be read").expected("one"));
        return restored(*scene, local).get();
    }

    /// Options that search the folder of a file first.
    static osg::ref_ptr<Options> besides(const std::string& path, const Options* options)
    {
        osg::ref_ptr<Options> local = options ? new Options(*options) : new Options;
        local->getDatabasePathList().push_front(osgDB::getFilePath(path));
        return local;
    }

    static ReadResult notFound(const std::string& file)
    {
        return ReadResult(file + ": " + fbrdf::Found("no such file").expected("a material"));
    }

    /// An effect with the properties of the option string; others have their defaults.
    static osg::ref_ptr<FactorizedBrdf> newEffect(const Options* options)
    {
        osg::ref_ptr<FactorizedBrdf> effect = new FactorizedBrdf;
        for (const std::string& problem :
             applyOptions(*effect, options ? options->getOptionString() : ""))
            OSG_WARN << "osgdb_fbrdf: " << problem << std::endl;
        return effect;
    }

    /// The effect, or a group with the environment that the option string names.
    static osg::ref_ptr<osg::Node> lit(FactorizedBrdf* effect, const Options* options)
    {
        std::vector<std::string> problems;
        const auto environment =
            environmentOf(options ? options->getOptionString() : "", options, problems);
        for (const std::string& problem : problems)
            OSG_WARN << "osgdb_fbrdf: " << problem << std::endl;
        if (!environment) return effect;
        osg::ref_ptr<osg::Group> group = new osg::Group;
        group->addChild(effect);
        group->addChild(environment);
        return group;
    }

    static ReadResult readModel(const PseudoName& name, const Options* options)
    {
        osg::ref_ptr<osg::Node> model = osgDB::readRefNodeFile(name.model, options);
        if (!model)
            return ReadResult(name.model + ": " +
                              fbrdf::Found("no model that can be read").expected("one"));
        osg::ref_ptr<FactorizedBrdf> effect = newEffect(options);
        effect->setName(name.model);
        // Materials may also be beside the model. Without one the fallback draws its part.
        for (const std::string& problem :
             applyMaterials(*effect, name.material, options ? options->getOptionString() : "",
                            besides(osgDB::findDataFile(name.model, options), options)))
            OSG_WARN << "osgdb_fbrdf: " << problem << std::endl;
        effect->addChild(model);
        return lit(effect, options).get();
    }

    mutable MaterialsInUse inUse_;
};

}  // namespace
}  // namespace osgFbrdf

using osgFbrdf::ReaderWriterFbrdf;
REGISTER_OSGPLUGIN(fbrdf, ReaderWriterFbrdf)
