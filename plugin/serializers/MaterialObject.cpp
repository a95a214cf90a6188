// A material without a file, as the bytes of a .fbrdf in base64: what the text, binary and XML
// streams of osgDB all carry whole. The plugin osgdb_fbrdf makes and reads them, so that this
// library needs no OpenImageIO.
#include <osgFbrdf/MaterialObject.h>

#include <osg/Notify>
#include <osgDB/ConvertBase64>
#include <osgDB/InputStream>
#include <osgDB/ObjectWrapper>
#include <osgDB/OutputStream>
#include <osgDB/Registry>

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
             << (found.empty() ? "found no plugin osgdb_fbrdf, expected it in OSG_LIBRARY_PATH"
                               : found)
             << std::endl;
}

bool checkFile(const MaterialObject& material)
{
    return material.valid();
}

bool readFile(osgDB::InputStream& stream, MaterialObject& material)
{
    std::string text;
    stream.readWrappedString(text);
    std::istringstream code(text);
    std::stringstream bytes;
    osgDB::Base64decoder().decode(code, bytes);
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
    std::istringstream plain(bytes.str());
    std::ostringstream code;
    osgDB::Base64encoder().encode(plain, code);
    stream.writeWrappedString(code.str());
    stream << std::endl;
    return true;
}

}  // namespace

REGISTER_OBJECT_WRAPPER(osgFbrdf_MaterialObject, new osgFbrdf::MaterialObject,
                        osgFbrdf::MaterialObject, "osg::Object osgFbrdf::MaterialObject")
{
    ADD_USER_SERIALIZER(File);
}
