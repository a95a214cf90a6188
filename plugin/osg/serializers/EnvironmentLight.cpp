// A picture that has a file is saved by its name; it is found again by osgDB's search paths. One
// that has none is saved itself: floats as numbers of 32 bits, which all streams of osgDB carry
// whole.
#include <osgFbrdf/EnvironmentLight.h>

#include <fbrdf/base/Found.h>
#include <fbrdf/environment/Panorama.h>

#include <osg/Notify>
#include <osgDB/InputStream>
#include <osgDB/ObjectWrapper>
#include <osgDB/OutputStream>

#include <cstring>

namespace {

using osgFbrdf::EnvironmentLight;

// Binary files have all properties in a fixed order, so a property that is added later must belong
// to a later format.
constexpr int kEnvironmentFormat = 1;
// More can only be damage: panoramas are made smaller than this.
constexpr unsigned int kMostTexels = 1u << 26;
constexpr unsigned int kTexelsInRow = 4;

bool checkFormat(const EnvironmentLight&)
{
    return true;
}

bool readFormat(osgDB::InputStream& stream, EnvironmentLight&)
{
    int format = 0;
    stream >> format;
    if (format > kEnvironmentFormat)
        OSG_WARN << "osgFbrdf: "
                 << fbrdf::Found("an EnvironmentLight of format " + std::to_string(format))
                        .expected("at most " + std::to_string(kEnvironmentFormat) +
                                  ": written by a newer version, what it added is lost")
                 << std::endl;
    return true;
}

bool writeFormat(osgDB::OutputStream& stream, const EnvironmentLight&)
{
    stream << kEnvironmentFormat << std::endl;
    return true;
}

bool checkPicture(const EnvironmentLight& light)
{
    return !light.getPictureFile().empty() || light.valid();
}

void readEmbeddedPicture(osgDB::InputStream& stream, EnvironmentLight& light)
{
    unsigned int width = 0, height = 0;
    stream >> width >> height >> stream.BEGIN_BRACKET;
    if (width < 1 || height < 1 || width > kMostTexels || height > kMostTexels / width) {
        OSG_WARN << "osgFbrdf: "
                 << fbrdf::Found("an environment of " + std::to_string(width) + " x " +
                                 std::to_string(height) + " texels")
                        .expected("at most " + std::to_string(kMostTexels))
                 << std::endl;
        return;
    }
    fbrdf::Panorama panorama{static_cast<int>(width), static_cast<int>(height), {}};
    while (panorama.texels.size() < size_t(width) * height && !stream.getException()) {
        fbrdf::Vec3f& texel = panorama.texels.emplace_back();
        for (int c = 0; c < 3; ++c) {
            unsigned int word = 0;
            stream >> word;
            std::memcpy(&texel[c], &word, sizeof(float));
        }
    }
    stream >> stream.END_BRACKET;
    if (!stream.getException()) light.setPanorama(panorama);
}

bool readPicture(osgDB::InputStream& stream, EnvironmentLight& light)
{
    std::string file;
    stream.readWrappedString(file);
    // A missing picture has given its warning; the scene is worth having without it.
    if (file.empty())
        readEmbeddedPicture(stream, light);
    else
        light.setPictureFile(file, stream.getOptions());
    return true;
}

void writeEmbeddedPicture(osgDB::OutputStream& stream, const fbrdf::Panorama& panorama)
{
    stream << static_cast<unsigned int>(panorama.width)
           << static_cast<unsigned int>(panorama.height) << stream.BEGIN_BRACKET << std::endl;
    for (size_t i = 0; i < panorama.texels.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            unsigned int word = 0;
            std::memcpy(&word, &panorama.texels[i][c], sizeof(float));
            stream << word;
        }
        if (i % kTexelsInRow == kTexelsInRow - 1) stream << std::endl;
    }
    stream << std::endl << stream.END_BRACKET;
}

bool writePicture(osgDB::OutputStream& stream, const EnvironmentLight& light)
{
    stream.writeWrappedString(light.getPictureFile());
    if (light.getPictureFile().empty()) writeEmbeddedPicture(stream, *light.getPanorama());
    stream << std::endl;
    return true;
}

}  // namespace

REGISTER_OBJECT_WRAPPER(
    osgFbrdf_EnvironmentLight, new osgFbrdf::EnvironmentLight, osgFbrdf::EnvironmentLight,
    "osgFbrdf::ClassicNumbers osg::Object osg::Node osg::Group osgFbrdf::EnvironmentLight")
{
    ADD_USER_SERIALIZER(Format);
    ADD_INT_SERIALIZER(FaceSize, 512);
    ADD_USER_SERIALIZER(Picture);
    ADD_FLOAT_SERIALIZER(Rotation, 0.0f);
    ADD_VEC3F_SERIALIZER(Intensity, osg::Vec3f(1.0f, 1.0f, 1.0f));
    ADD_INT_SERIALIZER(Lobes, 0);
}
