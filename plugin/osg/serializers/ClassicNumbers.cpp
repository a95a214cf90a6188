// The numbers of text and XML files in a host with a locale of its own. OSG's writers print numbers
// in the locale that std::locale::global had when the file was opened, 0,5 and 1.000 in a German
// one, and its readers understand neither. "osgFbrdf::ClassicNumbers" is the first associate of
// every class here: before anything of such an object is written, and that begins with its
// children, the stream gets the numbers of the classic locale. They stay for the rest of the file,
// as nobody could read one that has both. Nothing is written or read, so that files are the same
// with and without it.
#include <osg/Object>
#include <osgDB/ObjectWrapper>
#include <osgDB/OutputStream>

#include <locale>

namespace {

std::ios_base& classicNumbers(std::ios_base& stream)
{
    stream.imbue(std::locale::classic());
    return stream;
}

class ClassicNumbers : public osgDB::BaseSerializer {
public:
    ClassicNumbers() : BaseSerializer(READ_WRITE_PROPERTY) {}

    bool read(osgDB::InputStream&, osg::Object&) override { return true; }
    bool write(osgDB::OutputStream& stream, const osg::Object&) override
    {
        if (!stream.isBinary()) stream << &classicNumbers;
        return true;
    }
    const std::string& getName() const override { return name_; }

private:
    const std::string name_ = "ClassicNumbers";
};

}  // namespace

REGISTER_OBJECT_WRAPPER2(osgFbrdf_ClassicNumbers, nullptr, osg::Object, "osgFbrdf::ClassicNumbers",
                         "osgFbrdf::ClassicNumbers")
{
    wrapper->addSerializer(new ClassicNumbers, osgDB::BaseSerializer::RW_USER);
}
