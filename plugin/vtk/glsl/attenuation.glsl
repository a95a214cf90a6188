// VTK's attenuation over 1 / distance^2, by which the runtime multiplies.
float fbrdfShadow(int light, vec3 position, vec3 toLight)
{
    if (light >= vtkFbrdfAttenuated) return 1.0;
    vec4 attenuation = fbrdfLightVector(3 * fbrdfLightCount + light);
    vec3 difference = fbrdfLightVector(3 * light).xyz - position, axis = fbrdfLightVector(3 * light + 2).xyz;
    float distanceSquared = dot(difference, difference);
    float factor = distanceSquared / dot(attenuation.xyz, vec3(1.0, sqrt(distanceSquared), distanceSquared));
    if (!(attenuation.w > 0.0)) return factor;
    return factor * pow(max(-dot(axis, toLight), 0.0) * inversesqrt(dot(axis, axis)), attenuation.w);
}
