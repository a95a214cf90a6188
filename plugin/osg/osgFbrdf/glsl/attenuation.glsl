// OpenGL's attenuation and spot exponent of osg::Lights, which the runtime's lights do not have. The runtime multiplies
// intensity / distance^2 of each light by its hook fbrdfShadow, which is meant for shadows; here it is the attenuation
// over 1 / distance^2. One light takes three vectors in eye space:
//   place         where the light is; w: the exponent of a spot
//   coefficients  constant, linear, quadratic
//   axis          unit, where a spot shines
uniform vec4 osgFbrdfAttenuations[24];

// OpenGL 2.1 specification, section 2.14.1. index: of the attenuation; 8 for a light of the runtime.
float osgFbrdfAttenuation(int index, vec3 position, vec3 toLight)
{
    if (index >= 8) return 1.0;
    vec4 place = osgFbrdfAttenuations[3 * index];
    vec3 coefficients = osgFbrdfAttenuations[3 * index + 1].xyz, axis = osgFbrdfAttenuations[3 * index + 2].xyz;
    vec3 difference = place.xyz - position;
    float distanceSquared = dot(difference, difference);
    float factor = distanceSquared / dot(coefficients, vec3(1.0, sqrt(distanceSquared), distanceSquared));
    float cosine = max(-dot(axis, toLight), 0.0);
    return place.w > 0.0 ? factor * pow(cosine, place.w) : factor;
}
