#include <osgFbrdf/PointLights.h>

#include <osg/Notify>
#include <osg/Vec4f>
#include <osgDB/InputStream>
#include <osgDB/ObjectWrapper>
#include <osgDB/OutputStream>

namespace {

using osgFbrdf::PointLights;

// Longer lists are damage: 10 million lights are 320 MB.
constexpr unsigned int kMostLights = 10000000;

bool checkLights(const PointLights& node)
{
    return !node.getLights().empty();
}

/// A line: x y z and 1 (point) or 0 (towards a directional light); red green blue radius.
bool readLights(osgDB::InputStream& stream, PointLights& node)
{
    unsigned int count = 0;
    stream >> count >> stream.BEGIN_BRACKET;
    if (count > kMostLights) {
        OSG_WARN << "osgFbrdf: found " << count << " lights, expected at most " << kMostLights
                 << std::endl;
        return false;
    }
    for (unsigned int i = 0; i < count && !stream.getException(); ++i) {
        osg::Vec4f place, intensity;
        stream >> place >> intensity;
        const osg::Vec3f position(place.x(), place.y(), place.z()),
            colour(intensity.x(), intensity.y(), intensity.z());
        if (place.w() > 0.0f)
            node.addPoint(position, colour, intensity.w());
        else
            node.addDirectional(position, colour);
    }
    stream >> stream.END_BRACKET;
    return true;
}

bool writeLights(osgDB::OutputStream& stream, const PointLights& node)
{
    stream << static_cast<unsigned int>(node.getLights().size()) << stream.BEGIN_BRACKET
           << std::endl;
    for (const fbrdf::Light& light : node.getLights()) {
        const float w = light.type == fbrdf::Light::Type::point ? 1.0f : 0.0f;
        stream << osg::Vec4f(light.position.x, light.position.y, light.position.z, w)
               << osg::Vec4f(light.intensity.x, light.intensity.y, light.intensity.z, light.radius)
               << std::endl;
    }
    stream << stream.END_BRACKET << std::endl;
    return true;
}

}  // namespace

REGISTER_OBJECT_WRAPPER(osgFbrdf_PointLights, new osgFbrdf::PointLights, osgFbrdf::PointLights,
                        "osg::Object osg::Node osg::Group osgFbrdf::PointLights")
{
    ADD_USER_SERIALIZER(Lights);
}
