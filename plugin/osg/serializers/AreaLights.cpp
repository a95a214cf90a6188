#include <osgFbrdf/AreaLights.h>

#include <fbrdf/base/Found.h>

#include <osg/Notify>
#include <osg/Vec3f>
#include <osg/Vec4f>
#include <osgDB/InputStream>
#include <osgDB/ObjectWrapper>
#include <osgDB/OutputStream>

namespace {

using fbrdf::AreaLight;
using osgFbrdf::AreaLights;
using Shape = AreaLight::Shape;

// Longer lists can only be damage.
constexpr unsigned int kMostLights = 1000000, kMostCorners = 1000000;

bool checkLights(const AreaLights& node)
{
    return !node.getLights().empty();
}

/// Members of a light that its shape reads, each three numbers.
std::vector<fbrdf::Vec3f AreaLight::*> vectorsOf(Shape shape)
{
    switch (shape) {
        case Shape::sphere: return {&AreaLight::position};
        case Shape::disc: return {&AreaLight::position, &AreaLight::normal};
        case Shape::rectangle: return {&AreaLight::position, &AreaLight::axisU, &AreaLight::axisV};
        case Shape::tube: return {&AreaLight::position, &AreaLight::end};
        case Shape::polygon: return {};
    }
    return {};
}

void warn(const std::string& found, const std::string& expected)
{
    OSG_WARN << "osgFbrdf: " << fbrdf::Found(found).expected(expected) << std::endl;
}

fbrdf::Vec3f readVector(osgDB::InputStream& stream)
{
    osg::Vec3f v;
    stream >> v;
    return {v.x(), v.y(), v.z()};
}

osg::Vec3f toOsg(const fbrdf::Vec3f& v)
{
    return {v.x, v.y, v.z};
}

bool readVertices(osgDB::InputStream& stream, AreaLight& light)
{
    unsigned int count = 0;
    stream >> count;
    // One of more than kMostVertices is not valid, but is kept as every other.
    if (count > kMostCorners) {
        warn("an area light of " + std::to_string(count) + " vertices",
             "at most " + std::to_string(kMostCorners));
        return false;
    }
    for (unsigned int i = 0; i < count && !stream.getException(); ++i)
        light.vertices.push_back(readVector(stream));
    return true;
}

/// A light is the number of its shape (the place in AreaLight::Shape), 1 where it is two-sided or
/// 0, then red green blue radius, the size, and the vectors of its shape; a polygon has the number
/// of its vertices instead, and these.
bool readLight(osgDB::InputStream& stream, AreaLights& node)
{
    int shape = 0, twoSided = 0;
    osg::Vec4f radiance;
    AreaLight light;
    stream >> shape >> twoSided >> radiance >> light.size;
    if (shape < 0 || shape > static_cast<int>(Shape::polygon)) {
        warn("an area light of shape " + std::to_string(shape),
             "0 to " + std::to_string(static_cast<int>(Shape::polygon)) +
                 ": written by a newer version");
        return false;
    }
    light.shape = static_cast<Shape>(shape);
    light.twoSided = twoSided != 0;
    light.radiance = {radiance.x(), radiance.y(), radiance.z()};
    light.radius = radiance.w();
    for (const auto member : vectorsOf(light.shape)) light.*member = readVector(stream);
    if (light.shape == Shape::polygon && !readVertices(stream, light)) return false;
    node.addLight(light);
    return true;
}

bool readLights(osgDB::InputStream& stream, AreaLights& node)
{
    unsigned int count = 0;
    stream >> count >> stream.BEGIN_BRACKET;
    if (count > kMostLights) {
        warn(std::to_string(count) + " area lights", "at most " + std::to_string(kMostLights));
        return false;
    }
    for (unsigned int i = 0; i < count && !stream.getException(); ++i)
        if (!readLight(stream, node)) return false;
    stream >> stream.END_BRACKET;
    return true;
}

bool writeLights(osgDB::OutputStream& stream, const AreaLights& node)
{
    stream << static_cast<unsigned int>(node.getLights().size()) << stream.BEGIN_BRACKET
           << std::endl;
    for (const AreaLight& light : node.getLights()) {
        stream << static_cast<int>(light.shape) << static_cast<int>(light.twoSided)
               << osg::Vec4f(toOsg(light.radiance), light.radius) << light.size << std::endl;
        for (const auto member : vectorsOf(light.shape)) stream << toOsg(light.*member);
        if (light.shape == Shape::polygon)
            stream << static_cast<unsigned int>(light.vertices.size());
        for (const fbrdf::Vec3f& vertex : light.vertices)
            if (light.shape == Shape::polygon) stream << toOsg(vertex);
        stream << std::endl;
    }
    stream << stream.END_BRACKET << std::endl;
    return true;
}

}  // namespace

REGISTER_OBJECT_WRAPPER(
    osgFbrdf_AreaLights, new osgFbrdf::AreaLights, osgFbrdf::AreaLights,
    "osgFbrdf::ClassicNumbers osg::Object osg::Node osg::Group osgFbrdf::AreaLights")
{
    ADD_USER_SERIALIZER(Lights);
}
