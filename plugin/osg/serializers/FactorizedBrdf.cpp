// A material that has a file is saved by its name; it is found again by osgDB's search paths, the
// folder of the scene file among them. One that has none is saved itself, once for all effects that
// share it.
#include <osgFbrdf/FactorizedBrdf.h>

#include <fbrdf/base/Found.h>
#include <fbrdf/base/Percent.h>

#include <osg/Notify>
#include <osgDB/InputStream>
#include <osgDB/ObjectWrapper>
#include <osgDB/OutputStream>

#include <set>
#include <string>

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
// to a later format. Format 2 has materials in the scene itself, format 3 PreciseFiltering, format
// 4 FreeTextureUnits, format 5 Parts, format 6 ModelTextures and VertexHook, format 7 Accumulation.
constexpr int kEmbeddingFormat = 2, kPreciseFormat = 3, kFreeUnitsFormat = 4, kPartsFormat = 5,
              kTexturesFormat = 6, kFormat = 7;

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

bool hasParts(const FactorizedBrdf& effect)
{
    return !effect.getParts().empty();
}

bool hasModelTextures(const FactorizedBrdf& effect)
{
    return effect.getModelTextures().any();
}

bool hasVertexHook(const FactorizedBrdf& effect)
{
    return !effect.getVertexHook().glsl.empty();
}

/// The lowest format that can describe the effect, so that older readers give a warning only where
/// they lose something.
int formatOf(const FactorizedBrdf& effect)
{
    if (effect.getAccumulation() != fbrdf::ColourFormat::rgba32f) return kFormat;
    if (hasModelTextures(effect) || hasVertexHook(effect)) return kTexturesFormat;
    if (hasParts(effect)) return kPartsFormat;
    if (!effect.getFreeTextureUnits().empty()) return kFreeUnitsFormat;
    if (effect.getPreciseFiltering()) return kPreciseFormat;
    return isEmbedded(effect) ? kEmbeddingFormat : 1;
}

bool writeFormat(osgDB::OutputStream& stream, const FactorizedBrdf& effect)
{
    stream << formatOf(effect) << std::endl;
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

/// A property that binary files have from a format on.
class FromFormat : public osgDB::BaseSerializer {
public:
    FromFormat(int format, osgDB::BaseSerializer* property)
        : BaseSerializer(READ_WRITE_PROPERTY), format_(format), property_(property)
    {
    }
    const std::string& getName() const override { return property_->getName(); }
    bool read(osgDB::InputStream& stream, osg::Object& object) override
    {
        const bool exists = !stream.isBinary() || formatBeingRead >= format_;
        return !exists || property_->read(stream, object);
    }
    bool write(osgDB::OutputStream& stream, const osg::Object& object) override
    {
        const bool exists =
            !stream.isBinary() || formatOf(static_cast<const FactorizedBrdf&>(object)) >= format_;
        return !exists || property_->write(stream, object);
    }

private:
    int format_;
    osg::ref_ptr<osgDB::BaseSerializer> property_;
};

bool checkFreeTextureUnits(const FactorizedBrdf& effect)
{
    return !effect.getFreeTextureUnits().empty();
}

bool readFreeTextureUnits(osgDB::InputStream& stream, FactorizedBrdf& effect)
{
    int count = 0;
    stream >> count;
    std::set<int> units;
    for (int i = 0, unit = 0; i < count && !stream.getException(); ++i) {
        stream >> unit;
        units.insert(unit);
    }
    effect.setFreeTextureUnits(units);
    return true;
}

bool writeFreeTextureUnits(osgDB::OutputStream& stream, const FactorizedBrdf& effect)
{
    stream << static_cast<int>(effect.getFreeTextureUnits().size());
    for (const int unit : effect.getFreeTextureUnits()) stream << unit;
    stream << std::endl;
    return true;
}

// A name with a space in quotes would not do: OSG 3.6.5 loses it in XML.
void readPart(osgDB::InputStream& stream, FactorizedBrdf& effect)
{
    std::string name;
    stream >> name >> stream.BEGIN_BRACKET;
    const auto part = stream.readObjectOfType<FactorizedBrdf>();
    stream >> stream.END_BRACKET;
    if (part) effect.setPart(fbrdf::percentDecoded(name), part);
}

bool readParts(osgDB::InputStream& stream, FactorizedBrdf& effect)
{
    const int format = formatBeingRead;  // effects of parts have formats of their own
    unsigned int count = 0;
    stream >> count >> stream.BEGIN_BRACKET;
    for (unsigned int i = 0; i < count && !stream.getException(); ++i) readPart(stream, effect);
    stream >> stream.END_BRACKET;
    formatBeingRead = format;
    return true;
}

bool writeParts(osgDB::OutputStream& stream, const FactorizedBrdf& effect)
{
    stream << static_cast<unsigned int>(effect.getParts().size()) << stream.BEGIN_BRACKET
           << std::endl;
    for (const osgFbrdf::ModelPart& part : effect.getParts()) {
        stream << fbrdf::percentEncoded(part.name) << stream.BEGIN_BRACKET << std::endl;
        stream.writeObject(part.effect.get());
        stream << stream.END_BRACKET << std::endl;
    }
    stream << stream.END_BRACKET << std::endl;
    return true;
}

bool readModelTextures(osgDB::InputStream& stream, FactorizedBrdf& effect)
{
    osgFbrdf::ModelTextures textures;
    stream >> textures.tint >> textures.alpha >> textures.normal >> textures.tintsAll;
    effect.setModelTextures(textures);
    return true;
}

bool writeModelTextures(osgDB::OutputStream& stream, const FactorizedBrdf& effect)
{
    const osgFbrdf::ModelTextures& textures = effect.getModelTextures();
    stream << textures.tint << textures.alpha << textures.normal << textures.tintsAll << std::endl;
    return true;
}

// Code has lines, quotes and braces, so it is written as one word.
bool readVertexHook(osgDB::InputStream& stream, FactorizedBrdf& effect)
{
    osgFbrdf::VertexHook hook;
    std::string glsl, name;
    int attributes = 0;
    stream >> glsl >> attributes;
    for (int i = 0; i < attributes && !stream.getException(); ++i) {
        unsigned int index = 0;
        stream >> name >> index;
        hook.attributes[fbrdf::percentDecoded(name)] = index;
    }
    hook.glsl = fbrdf::percentDecoded(glsl);
    effect.setVertexHook(hook);
    return true;
}

bool writeVertexHook(osgDB::OutputStream& stream, const FactorizedBrdf& effect)
{
    const osgFbrdf::VertexHook& hook = effect.getVertexHook();
    stream << fbrdf::percentEncoded(hook.glsl) << static_cast<int>(hook.attributes.size());
    for (const auto& [name, index] : hook.attributes)
        stream << fbrdf::percentEncoded(name) << index;
    stream << std::endl;
    return true;
}

bool checkAccumulation(const FactorizedBrdf& effect)
{
    return effect.getAccumulation() != fbrdf::ColourFormat::rgba32f;
}

bool readAccumulation(osgDB::InputStream& stream, FactorizedBrdf& effect)
{
    std::string name;
    stream >> name;
    for (const auto format : osgFbrdf::kAccumulationFormats)
        if (name == fbrdf::colourFormatName(format)) {
            effect.setAccumulation(format);
            return true;
        }
    OSG_WARN << "osgFbrdf: "
             << fbrdf::Found("accumulation '" + name + "'").expected("RGBA32F, RGBA16F or RGBA8")
             << std::endl;
    return true;
}

bool writeAccumulation(osgDB::OutputStream& stream, const FactorizedBrdf& effect)
{
    stream << std::string(fbrdf::colourFormatName(effect.getAccumulation())) << std::endl;
    return true;
}

// A technique that the runtime gets later must not take this number, which is in scene files:
// it needs a table from numbers of files to indices.
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
                        "osgFbrdf::ClassicNumbers osg::Object osg::Node osg::Group osgFX::Effect "
                        "osgFbrdf::FactorizedBrdf")
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
    using Precise = osgDB::PropByValSerializer<FactorizedBrdf, bool>;
    wrapper->addSerializer(
        new FromFormat(kPreciseFormat,
                       new Precise("PreciseFiltering", false, &FactorizedBrdf::getPreciseFiltering,
                                   &FactorizedBrdf::setPreciseFiltering)),
        osgDB::BaseSerializer::RW_BOOL);
    using User = osgDB::UserSerializer<FactorizedBrdf>;
    wrapper->addSerializer(
        new FromFormat(kFreeUnitsFormat, new User("FreeTextureUnits", &checkFreeTextureUnits,
                                                  &readFreeTextureUnits, &writeFreeTextureUnits)),
        osgDB::BaseSerializer::RW_USER);
    wrapper->addSerializer(
        new FromFormat(kPartsFormat, new User("Parts", &hasParts, &readParts, &writeParts)),
        osgDB::BaseSerializer::RW_USER);
    wrapper->addSerializer(
        new FromFormat(kTexturesFormat, new User("ModelTextures", &hasModelTextures,
                                                 &readModelTextures, &writeModelTextures)),
        osgDB::BaseSerializer::RW_USER);
    wrapper->addSerializer(
        new FromFormat(kTexturesFormat,
                       new User("VertexHook", &hasVertexHook, &readVertexHook, &writeVertexHook)),
        osgDB::BaseSerializer::RW_USER);
    wrapper->addSerializer(new FromFormat(kFormat, new User("Accumulation", &checkAccumulation,
                                                            &readAccumulation, &writeAccumulation)),
                           osgDB::BaseSerializer::RW_USER);
}
