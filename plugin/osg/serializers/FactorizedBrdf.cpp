// A material that has a file is saved by its name; it is found again by osgDB's search paths, the
// folder of the scene file among them. One that has none is saved itself, once for all effects that
// share it.
#include <osgFbrdf/FactorizedBrdf.h>

#include <fbrdf/base/Found.h>

#include <osg/Notify>
#include <osgDB/InputStream>
#include <osgDB/ObjectWrapper>
#include <osgDB/OutputStream>

namespace {

using osgFbrdf::FactorizedBrdf;

bool hasMaterial(const FactorizedBrdf& effect)
{
    return effect.getMaterial() && effect.getMaterial()->valid();
}

bool isEmbedded(const FactorizedBrdf& effect)
{
    return effect.getMaterialFile().empty() && hasMaterial(effect);
}

bool checkMaterialFile(const FactorizedBrdf& effect)
{
    return !effect.getMaterialFile().empty() || hasMaterial(effect);
}

void readEmbedded(osgDB::InputStream& stream, FactorizedBrdf& effect)
{
    stream >> stream.BEGIN_BRACKET;
    const auto material = stream.readObjectOfType<osgFbrdf::MaterialObject>();
    stream >> stream.END_BRACKET;
    if (material && material->valid()) effect.setMaterial(material);
}

/// In format 2 the name may be empty, and the material itself follows.
bool readMaterialFile(osgDB::InputStream& stream, FactorizedBrdf& effect)
{
    std::string file;
    stream.readWrappedString(file);
    // A missing material has given its warning; the model is worth having without it.
    if (file.empty())
        readEmbedded(stream, effect);
    else
        effect.setMaterialFile(file, stream.getOptions());
    return true;
}

bool writeMaterialFile(osgDB::OutputStream& stream, const FactorizedBrdf& effect)
{
    stream.writeWrappedString(effect.getMaterialFile());
    if (isEmbedded(effect)) {
        stream << stream.BEGIN_BRACKET << std::endl;
        stream.writeObject(effect.getMaterial());
        stream << stream.END_BRACKET;
    }
    stream << std::endl;
    return true;
}

// Binary files have all properties in a fixed order, so a property that is added later must belong
// to a later format. Format 2 has materials in the scene itself, format 3 PreciseFiltering.
constexpr int kEmbeddingFormat = 2, kFormat = 3;

thread_local int formatBeingRead = 0;  ///< of the effect whose properties are read

bool checkFormat(const FactorizedBrdf&)
{
    return true;
}

bool readFormat(osgDB::InputStream& stream, FactorizedBrdf&)
{
    int format = 0;
    stream >> format;
    formatBeingRead = format;
    if (format > kFormat)
        OSG_WARN << "osgFbrdf: "
                 << fbrdf::Found("a FactorizedBrdf of format " + std::to_string(format))
                        .expected("at most " + std::to_string(kFormat) +
                                  ": written by a newer version, what it added is lost")
                 << std::endl;
    return true;
}

/// The lowest format that can describe the effect, so that older readers give a warning only where
/// they lose something.
bool writeFormat(osgDB::OutputStream& stream, const FactorizedBrdf& effect)
{
    const int format = isEmbedded(effect) ? kEmbeddingFormat : 1;
    stream << (effect.getPreciseFiltering() ? kFormat : format) << std::endl;
    return true;
}

constexpr const char* kTransferNames[] = {"linear", "exposure", "srgb", "toneMap"};

bool checkTransfer(const FactorizedBrdf& effect)
{
    return effect.getTransfer() != fbrdf::Transfer::linear;
}

bool readTransfer(osgDB::InputStream& stream, FactorizedBrdf& effect)
{
    std::string name;
    stream >> name;
    for (int i = 0; i < 4; ++i)
        if (name == kTransferNames[i]) {
            effect.setTransfer(static_cast<fbrdf::Transfer>(i));
            return true;
        }
    OSG_WARN
        << "osgFbrdf: "
        << fbrdf::Found("transfer '" + name + "'").expected("linear, exposure, srgb or toneMap")
        << std::endl;
    return true;
}

bool writeTransfer(osgDB::OutputStream& stream, const FactorizedBrdf& effect)
{
    stream << std::string(kTransferNames[static_cast<int>(effect.getTransfer())]) << std::endl;
    return true;
}

/// In binary files it exists only where it is true, and the format says so.
class PreciseFiltering : public osgDB::PropByValSerializer<FactorizedBrdf, bool> {
public:
    PreciseFiltering()
        : PropByValSerializer("PreciseFiltering", false, &FactorizedBrdf::getPreciseFiltering,
                              &FactorizedBrdf::setPreciseFiltering)
    {
    }
    bool read(osgDB::InputStream& stream, osg::Object& object) override
    {
        const bool exists = !stream.isBinary() || formatBeingRead >= kFormat;
        return !exists || PropByValSerializer::read(stream, object);
    }
    bool write(osgDB::OutputStream& stream, const osg::Object& object) override
    {
        const auto& effect = static_cast<const FactorizedBrdf&>(object);
        const bool exists = !stream.isBinary() || effect.getPreciseFiltering();
        return !exists || PropByValSerializer::write(stream, object);
    }
};

// A technique that the runtime gets later must not take this number, which is in scene files: it
// needs a table from numbers of files to indices.
static_assert(osgFbrdf::kDiffuseFallback == 3, "scene files have this number");

bool checkTechnique(const FactorizedBrdf& effect)
{
    return effect.getSelectedTechnique() != osgFX::Effect::AUTO_DETECT;
}

bool readTechnique(osgDB::InputStream& stream, FactorizedBrdf& effect)
{
    int index = osgFX::Effect::AUTO_DETECT;
    stream >> index;
    if (index >= osgFX::Effect::AUTO_DETECT && index <= osgFbrdf::kDiffuseFallback) {
        effect.selectTechnique(index);
        return true;
    }
    OSG_WARN << "osgFbrdf: "
             << fbrdf::Found("technique " + std::to_string(index))
                    .expected("-1 to " + std::to_string(osgFbrdf::kDiffuseFallback))
             << std::endl;
    return true;
}

bool writeTechnique(osgDB::OutputStream& stream, const FactorizedBrdf& effect)
{
    stream << effect.getSelectedTechnique() << std::endl;
    return true;
}

}  // namespace

REGISTER_OBJECT_WRAPPER(osgFbrdf_FactorizedBrdf, new osgFbrdf::FactorizedBrdf,
                        osgFbrdf::FactorizedBrdf,
                        "osg::Object osg::Node osg::Group osgFX::Effect osgFbrdf::FactorizedBrdf")
{
    ADD_USER_SERIALIZER(Format);
    ADD_USER_SERIALIZER(MaterialFile);
    ADD_FLOAT_SERIALIZER(Exposure, 1.0f);
    ADD_INT_SERIALIZER(LightsPerPass, 8);
    ADD_INT_SERIALIZER(LookupsPerPass, 0);
    ADD_INT_SERIALIZER(FirstTextureUnit, 0);
    ADD_BOOL_SERIALIZER(FloatTarget, false);
    ADD_BOOL_SERIALIZER(DerivedTangents, false);
    ADD_USER_SERIALIZER(Technique);
    ADD_USER_SERIALIZER(Transfer);
    ADD_BOOL_SERIALIZER(Reloading, false);
    wrapper->addSerializer(new PreciseFiltering, osgDB::BaseSerializer::RW_BOOL);
}
