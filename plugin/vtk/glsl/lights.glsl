// The lights of a vtkRenderer, in rows of 256 texels: the three vectors of each light (LightVectors.h), then for each of
// the first vtkFbrdfAttenuated lights its constant, linear and quadratic attenuation and the exponent of its cone.
uniform sampler2D vtkFbrdfLights;
uniform int vtkFbrdfAttenuated;

vec4 vtkFbrdfTexel(int index)
{
    return texelFetch(vtkFbrdfLights, ivec2(index & 255, index >> 8), 0);
}

// VTK's attenuation over 1 / distance^2, by which the irradiance of the runtime's light is multiplied. place, axis: of
// the light.
float vtkFbrdfAttenuation(int light, vec3 place, vec3 axis, vec3 position, vec3 wi)
{
    if (light >= vtkFbrdfAttenuated) return 1.0;
    vec4 attenuation = vtkFbrdfTexel(3 * fbrdfLightCount + light);
    vec3 difference = place - position;
    float distanceSquared = dot(difference, difference);
    float factor = distanceSquared / dot(attenuation.xyz, vec3(1.0, sqrt(distanceSquared), distanceSquared));
    if (!(attenuation.w > 0.0)) return factor;
    return factor * pow(max(-dot(axis, wi), 0.0) * inversesqrt(dot(axis, axis)), attenuation.w);
}

vec3 fbrdfHostLight(int light, vec3 position, out vec3 wi)
{
    vec4 a = vtkFbrdfTexel(3 * light), b = vtkFbrdfTexel(3 * light + 1), c = vtkFbrdfTexel(3 * light + 2);
    vec3 irradiance = fbrdfIrradiance(a, b, c, position, wi);
    return irradiance * vtkFbrdfAttenuation(light, a.xyz, c.xyz, position, wi);
}
