// OGRE's lights as it defines them, from a texture with a row for each light of the view (LightRow.h):
//   place        position in eye space, or the unit direction towards a directional light; range, 0 for a directional light
//   colour       irradiance at attenuation 1; cosine of the outer cone, -2 where there is no cone, -3 where the light also
//                falls off as 1 / r^2, so that nothing more of it has to be fetched
//   attenuation  constant, linear, quadratic; falloff of the cone
//   axis         unit, along which a spot shines; 1 / (cosine of the inner cone - that of the outer)
uniform sampler2D fbrdfLightMap;
uniform float fbrdfLightStep;        // 1 / rows of the texture
uniform float fbrdfListed;           // 1: lights of this object are the rows in fbrdfLightList, else the first rows
uniform float fbrdfShadowedLight;    // the light that OGRE's integrated shadow belongs to, -1: none
uniform vec4 fbrdfLightList[64];
float fbrdfIntegratedShadow = 1.0;   // how much of that light arrives

vec4 fbrdfLightTexel(int column, float row)
{
    return FBRDF_TEXTURE2(fbrdfLightMap, vec2((float(column) + 0.5) * 0.25, (row + 0.5) * fbrdfLightStep));
}

vec3 fbrdfHostLight(int light, vec3 position, out vec3 wi)
{
    float row = float(light);
    if (fbrdfListed > 0.0) {
        int four = light / 4;
        row = fbrdfLightList[four][light - 4 * four];
    }
    vec4 place = fbrdfLightTexel(0, row);
    vec3 toLight = place.xyz - (place.w > 0.0 ? position : vec3(0.0));
    float distanceSquared = dot(toLight, toLight);
    wi = toLight * inversesqrt(max(distanceSquared, 1e-30));
    if (place.w > 0.0 && distanceSquared > place.w * place.w) return vec3(0.0);
    vec4 colour = fbrdfLightTexel(1, row);
    float share = float(light) == fbrdfShadowedLight ? fbrdfIntegratedShadow : 1.0, edge = 1.0;
    if (colour.w > -1.5) {
        vec4 axis = fbrdfLightTexel(3, row);
        edge = clamp((-dot(axis.xyz, wi) - colour.w) * axis.w, 0.0, 1.0);
        if (!(edge > 0.0)) return vec3(0.0);
    }
    if (colour.w < -2.5) {
        share /= max(distanceSquared, 1e-12);
    } else if (place.w > 0.0) {
        vec4 attenuation = fbrdfLightTexel(2, row);
        share /= max(dot(attenuation.xyz, vec3(1.0, sqrt(distanceSquared), distanceSquared)), 1e-12);
        if (edge < 1.0) share *= pow(edge, attenuation.w);
    }
    return colour.rgb * share;
}
