#include <osgFbrdf/PointLights.h>

#include <fbrdf/base/Found.h>

#include <osg/Notify>
#include <osg/Vec2f>
#include <osg/Vec3f>
#include <osg/Vec4f>
#include <osgDB/InputStream>
#include <osgDB/ObjectWrapper>
#include <osgDB/OutputStream>

namespace {

using osgFbrdf::PointLights;

// Longer lists can only be damage: 10 million lights take 320 MB.
constexpr unsigned int kMostLights = 10000000;

bool checkLights(const PointLights& node)
{
    return !node.getLights().empty();
}

using Type = fbrdf::Light::Type;

/// A line has x y z of the position, or of the direction to a directional light, then 0 for a
/// directional light, 1 for a point light and 2 for a spot, then red green blue radius. A spot has
/// a second line: its axis, inner and outer angle.
osg::Vec4f placeOf(const fbrdf::Light& light)
{
    const float kind = light.type == Type::directional ? 0.0f
                       : light.type == Type::spot      ? 2.0f
                                                       : 1.0f;
    return {light.position.x, light.position.y, light.position.z, kind};
}

void readLight(osgDB::InputStream& stream, PointLights& node)
{
    osg::Vec4f place, intensity;
    stream >> place >> intensity;
    const osg::Vec3f position(place.x(), place.y(), place.z()),
        colour(intensity.x(), intensity.y(), intensity.z());
    if (place.w() < 0.5f) return node.addDirectional(position, colour);
    if (place.w() < 1.5f) return node.addPoint(position, colour, intensity.w());
    PointLights::Spot spot;
    osg::Vec2f angles;
    stream >> spot.axis >> angles;
    spot.position = position;
    spot.intensity = colour;
    spot.innerAngle = angles.x();
    spot.outerAngle = angles.y();
    spot.radius = intensity.w();
    node.addSpot(spot);
}

bool readLights(osgDB::InputStream& stream, PointLights& node)
{
    unsigned int count = 0;
    stream >> count >> stream.BEGIN_BRACKET;
    if (count > kMostLights) {
        OSG_WARN << "osgFbrdf: "
                 << fbrdf::Found(std::to_string(count) + " lights")
                        .expected("at most " + std::to_string(kMostLights))
                 << std::endl;
        return false;
    }
    for (unsigned int i = 0; i < count && !stream.getException(); ++i) readLight(stream, node);
    stream >> stream.END_BRACKET;
    return true;
}

bool writeLights(osgDB::OutputStream& stream, const PointLights& node)
{
    stream << static_cast<unsigned int>(node.getLights().size()) << stream.BEGIN_BRACKET
           << std::endl;
    for (const fbrdf::Light& light : node.getLights()) {
        stream << placeOf(light)
               << osg::Vec4f(light.intensity.x, light.intensity.y, light.intensity.z, light.radius)
               << std::endl;
        if (light.type == Type::spot)
            stream << osg::Vec3f(light.axis.x, light.axis.y, light.axis.z)
                   << osg::Vec2f(light.innerAngle, light.outerAngle) << std::endl;
    }
    stream << stream.END_BRACKET << std::endl;
    return true;
}

}  // namespace

REGISTER_OBJECT_WRAPPER(
    osgFbrdf_PointLights, new osgFbrdf::PointLights, osgFbrdf::PointLights,
    "osgFbrdf::ClassicNumbers osg::Object osg::Node osg::Group osgFbrdf::PointLights")
{
    ADD_USER_SERIALIZER(Lights);
}
