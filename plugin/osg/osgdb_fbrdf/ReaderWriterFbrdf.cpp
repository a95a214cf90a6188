// osgdb_fbrdf: materials for osgDB. FILE.fbrdf is a sphere of that material, or the material itself
// where osgFbrdf::readMaterialObject() asks; MODEL.EXT.[FILE].fbrdf is MODEL.EXT drawn with it.
// SCENE.EXT.fbrdf, where that is no material, is SCENE.EXT in the plain form
// (osgFbrdf/PlainForm.h): written and restored. Written to FILE.fbrdf and to streams are materials:
// of an object, or the one of a scene.
#include "Arguments.h"
#include "MaterialOf.h"
#include "Sphere.h"

#include <osgFbrdf/FactorizedBrdf.h>
#include <osgFbrdf/PlainForm.h>

#include <fbrdf/base/Error.h>
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
            "Factored BRDF, read and written; MODEL.EXT.[FILE.fbrdf].fbrdf is a model with it; "
            "SCENE.EXT.fbrdf writes and reads SCENE.EXT for readers without osgFbrdf");
        for (const OptionText& option : optionTexts()) supportsOption(option.name, option.text);
    }

    const char* className() const override { return "Factored BRDF reader"; }

    ReadResult readObject(const std::string& file, const Options* options) const override
    {
        const bool material = options && !options->getPluginStringData(kReadMaterial).empty();
        return material ? readMaterialFile(file, options) : readNode(file, options);
    }

    ReadResult readNode(const std::string& file, const Options* options) const override
    {
        if (!acceptsExtension(osgDB::getLowerCaseFileExtension(file)))
            return ReadResult::FILE_NOT_HANDLED;
        const PseudoName name = pseudoName(file);
        if (!name.model.empty()) return readModel(name, options);
        if (osgDB::findDataFile(file, options).empty() && !plainName(file).empty())
            return readPlain(plainName(file), options);
        const ReadResult material = readMaterialFile(file, options);
        if (!material.success()) return material;
        osg::ref_ptr<FactorizedBrdf> effect = newEffect(options);
        effect->setMaterialFile(file, options);
        effect->addChild(unitSphere());
        return effect.get();
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
        return effect.get();
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

    /// What became of write(the material of the object).
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

    static ReadResult readMaterialFile(const std::string& file, const Options* options)
    {
        const std::string path = osgDB::findDataFile(file, options);
        if (path.empty()) return notFound(file);
        if (!fbrdf::isMaterialFile(path)) return ReadResult::FILE_NOT_HANDLED;
        try {
            return new MaterialObject(fbrdf::readMaterial(path), file);
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
        if (!scene) return ReadResult(name + ": found no scene that can be read");
        return restored(*scene, local).get();
    }

    /// Options that look in the folder of a file first.
    static osg::ref_ptr<Options> besides(const std::string& path, const Options* options)
    {
        osg::ref_ptr<Options> local = options ? new Options(*options) : new Options;
        local->getDatabasePathList().push_front(osgDB::getFilePath(path));
        return local;
    }

    static ReadResult notFound(const std::string& file)
    {
        return ReadResult(file + ": found no such file, expected a material");
    }

    /// The effect with what the option string says; what it does not say stays the default.
    static osg::ref_ptr<FactorizedBrdf> newEffect(const Options* options)
    {
        osg::ref_ptr<FactorizedBrdf> effect = new FactorizedBrdf;
        for (const std::string& problem :
             applyOptions(*effect, options ? options->getOptionString() : ""))
            OSG_WARN << "osgdb_fbrdf: " << problem << std::endl;
        return effect;
    }

    static ReadResult readModel(const PseudoName& name, const Options* options)
    {
        osg::ref_ptr<osg::Node> model = osgDB::readRefNodeFile(name.model, options);
        if (!model) return ReadResult(name.model + ": found no model that can be read");
        osg::ref_ptr<FactorizedBrdf> effect = newEffect(options);
        effect->setName(name.model);
        // Found beside the model too. Without its material the model is drawn by the fallback.
        effect->setMaterialFile(name.material,
                                besides(osgDB::findDataFile(name.model, options), options));
        effect->addChild(model);
        return effect.get();
    }
};

}  // namespace
}  // namespace osgFbrdf

using osgFbrdf::ReaderWriterFbrdf;
REGISTER_OSGPLUGIN(fbrdf, ReaderWriterFbrdf)
