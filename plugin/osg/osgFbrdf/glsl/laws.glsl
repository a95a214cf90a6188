// What an osg::Light has that a light of the runtime has not: a hook of the runtime, so what it returns is a factor of
// intensity / distance^2.
// A law is three vectors in eye space:
//   position     and the exponent of a spot
//   attenuation  constant, linear, quadratic
//   axis         unit, where a spot shines
uniform vec4 osgFbrdfLaws[24];

// OpenGL 2.1 specification, section 2.14.1. law: -1 for lights that have none.
float fbrdfShadow(int law, vec3 position, vec3 toLight)
{
    if (law < 0) return 1.0;
    vec4 place = osgFbrdfLaws[3 * law], attenuation = osgFbrdfLaws[3 * law + 1];
    vec3 way = place.xyz - position;
    float distanceSquared = dot(way, way);
    float factor = distanceSquared / dot(attenuation.xyz, vec3(1.0, sqrt(distanceSquared), distanceSquared));
    float cosine = max(-dot(osgFbrdfLaws[3 * law + 2].xyz, toLight), 0.0);
    return place.w > 0.0 ? factor * pow(cosine, place.w) : factor;
}
