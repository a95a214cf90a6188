// A material without a file is saved as the bytes of a .fbrdf, in numbers of 32 bits, which the
// text, binary and XML streams of osgDB all carry whole. A string in quotes would not do: where a
// text file ends within one, OSG 3.6.5 reads on for ever. The plugin osgdb_fbrdf makes and reads
// the bytes, so that this library need not link fbrdf::io.
#include <fbrdf/base/Found.h>

#include <osgFbrdf/MaterialObject.h>

#include <osg/Notify>
#include <osgDB/InputStream>
#include <osgDB/ObjectWrapper>
#include <osgDB/OutputStream>
#include <osgDB/Registry>

#include <algorithm>
#include <sstream>

namespace {

using osgFbrdf::MaterialObject;

osgDB::ReaderWriter* materialFormat()
{
    return osgDB::Registry::instance()->getReaderWriterForExtension("fbrdf");
}

void warn(const MaterialObject& material, const std::string& found)
{
    OSG_WARN << "osgFbrdf: material '" << material.getName() << "': "
             << (found.empty()
                     ? fbrdf::Found("no plugin osgdb_fbrdf").expected("it in OSG_LIBRARY_PATH")
                     : found)
             << std::endl;
}

bool checkFile(const MaterialObject& material)
{
    return material.valid();
}

// Longer ones can only be damage: the reader of .fbrdf takes no more than this.
constexpr unsigned int kMostBytes = 256u << 20;
constexpr unsigned int kWordsInRow = 8;

std::string readBytes(osgDB::InputStream& stream)
{
    unsigned int count = 0, word = 0;
    stream >> count >> stream.BEGIN_BRACKET;
    std::string bytes;
    while (bytes.size() < std::min(count, kMostBytes) && !stream.getException()) {
        stream >> word;
        for (unsigned int k = 0; k < 4; ++k)
            bytes += static_cast<char>(static_cast<unsigned char>(word >> (8 * k)));
    }
    stream >> stream.END_BRACKET;
    bytes.resize(std::min<size_t>(count, bytes.size()));
    return bytes;
}

void writeBytes(osgDB::OutputStream& stream, const std::string& bytes)
{
    stream << static_cast<unsigned int>(bytes.size()) << stream.BEGIN_BRACKET << std::endl;
    for (size_t i = 0; i < bytes.size(); i += 4) {
        unsigned int word = 0;
        for (size_t k = i; k < std::min(i + 4, bytes.size()); ++k)
            word |= static_cast<unsigned int>(static_cast<unsigned char>(bytes[k]))
                    << (8 * (k - i));
        stream << word;
        if (i / 4 % kWordsInRow == kWordsInRow - 1) stream << std::endl;
    }
    stream << std::endl << stream.END_BRACKET << std::endl;
}

bool readFile(osgDB::InputStream& stream, MaterialObject& material)
{
    std::istringstream bytes(readBytes(stream));
    auto* format = materialFormat();
    auto result = format ? format->readObject(bytes, nullptr) : osgDB::ReaderWriter::ReadResult();
    if (const auto* read = dynamic_cast<const MaterialObject*>(result.getObject()))
        material.take(*read);
    else
        warn(material, format ? result.message() : "");
    return true;
}

bool writeFile(osgDB::OutputStream& stream, const MaterialObject& material)
{
    std::ostringstream bytes;
    auto* format = materialFormat();
    const auto result =
        format ? format->writeObject(material, bytes, nullptr) : osgDB::ReaderWriter::WriteResult();
    if (!result.success()) warn(material, format ? result.message() : "");
    writeBytes(stream, bytes.str());
    return true;
}

}  // namespace

REGISTER_OBJECT_WRAPPER(osgFbrdf_MaterialObject, new osgFbrdf::MaterialObject,
                        osgFbrdf::MaterialObject,
                        "osgFbrdf::ClassicNumbers osg::Object osgFbrdf::MaterialObject")
{
    ADD_USER_SERIALIZER(File);
}
