// The split sum (Karis 2013, "Real Shading in Unreal Engine 4"): a prefiltered environment at one level, a table of the
// albedo of white and black GGX, and the irradiance.
// peerParameters: (f0, level of the highlight), (kd, level of the irradiance), (alpha, alpha^2, -, -).
uniform samplerCube peerEnvironment;
uniform sampler2D peerAlbedo;
uniform mat3 peerToEnvironment;
uniform vec4 peerParameters[3];

void main()
{
    vec3 n = normalize(fbrdfNormal), wo = fbrdfToViewer();
    float NoV = dot(n, wo);
    vec3 axis = mix(2.0 * NoV * n - wo, n, peerParameters[2].y);
    vec3 highlight = textureLod(peerEnvironment, peerToEnvironment * axis, peerParameters[0].w).rgb;
    vec3 irradiance = textureLod(peerEnvironment, peerToEnvironment * n, peerParameters[1].w).rgb;
    vec2 albedo = texture(peerAlbedo, vec2(NoV, peerParameters[2].x)).rg;
    vec3 sum = highlight * (peerParameters[0].rgb * albedo.x + albedo.y) + peerParameters[1].rgb * irradiance;
    fbrdfColour = vec4(NoV > 0.0 ? sum : vec3(0.0), 1.0);
}
