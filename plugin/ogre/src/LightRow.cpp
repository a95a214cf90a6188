#include "LightRow.h"

#include <fbrdf/brdf/Conventions.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace ogreFbrdf {
namespace {

/// Cosines that stand for "no cone", and for that with 1 / r^2.
constexpr float kNoCone = -2.0f, kInverseSquare = -3.0f;
/// An edge of a cone is at least this wide in cosine, so that it stays finite.
constexpr double kNarrowestEdge = 1e-6;

glm::dvec3 vec(const Ogre::Vector3& v)
{
    return {v.x, v.y, v.z};
}

glm::vec3 unitInEye(const Ogre::Vector3& direction, const glm::dmat4& toEye)
{
    const glm::dvec3 moved(toEye * glm::dvec4(vec(direction), 0.0));
    const double length = glm::length(moved);
    return length > 0.0 ? moved / length : glm::dvec3(0.0);
}

void setCone(LightRow& row, const Ogre::Light& light, const glm::dmat4& toEye)
{
    const double inner = std::cos(
                     0.5 * static_cast<double>(light.getSpotlightInnerAngle().valueRadians())),
                 outer = std::cos(
                     0.5 * static_cast<double>(light.getSpotlightOuterAngle().valueRadians()));
    row[1].w = static_cast<float>(outer);
    row[2].w = light.getSpotlightFalloff();
    row[3] = glm::vec4(unitInEye(light.getDerivedDirection(), toEye),
                       static_cast<float>(1.0 / std::max(inner - outer, kNarrowestEdge)));
}

bool isFinite(const LightRow& row)
{
    for (const glm::vec4& texel : row)
        for (int i = 0; i < 4; ++i)
            if (!std::isfinite(texel[i])) return false;
    return true;
}

}  // namespace

LightRow lightRow(const Ogre::Light& light, const glm::dmat4& toEye)
{
    LightRow row{};
    const Ogre::ColourValue colour = light.getDiffuseColour() * light.getPowerScale();
    row[1] = glm::vec4(static_cast<float>(fbrdf::kPi) * glm::vec3(colour.r, colour.g, colour.b),
                       kNoCone);
    if (light.getType() == Ogre::Light::LT_DIRECTIONAL) {
        row[0] = glm::vec4(unitInEye(-light.getDerivedDirection(), toEye), 0.0f);
    } else {
        const glm::dvec4 place = toEye * glm::dvec4(vec(light.getDerivedPosition()), 1.0);
        row[0] = glm::vec4(glm::vec3(place), light.getAttenuationRange());
        row[2] = glm::vec4(light.getAttenuationConstant(), light.getAttenuationLinear(),
                           light.getAttenuationQuadric(), 0.0f);
        if (light.getType() == Ogre::Light::LT_SPOTLIGHT)
            setCone(row, light, toEye);
        else if (row[2].x == 0.0f && row[2].y == 0.0f && row[2].z > 0.0f)
            row[1] = glm::vec4(glm::vec3(row[1]) / row[2].z, kInverseSquare);
        // A range of 0 would read as a directional light.
        if (!(row[0].w > 0.0f)) row = {};
    }
    return isFinite(row) ? row : LightRow{};
}

}  // namespace ogreFbrdf
