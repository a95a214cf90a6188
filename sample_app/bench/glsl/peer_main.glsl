// The loop over lights of every peer, as the runtime writes it. A peer defines peerView, which does once what does not
// depend on the light, and peerBrdf. PEER_LIGHTS: the size of the array of lights.
uniform vec4 fbrdfLights[3 * PEER_LIGHTS];
uniform int fbrdfLightCount;

void main()
{
    FbrdfShadingFrame frame = fbrdfShadingFrame(fbrdfNormal, fbrdfTangent);
    vec3 wo = fbrdfToViewer();
    float NoV = dot(frame.n, wo);
    peerView(frame, wo, NoV);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < fbrdfLightCount; ++i) {
        vec4 position = fbrdfLights[3 * i], intensity = fbrdfLights[3 * i + 1];
        vec2 squares;
        vec3 wi = fbrdfToLight(position, intensity.w, fbrdfPosition, squares);
        float NoL = dot(frame.n, wi);
        if (NoL > 0.0) {
            vec3 weight = intensity.rgb * (NoL * fbrdfFalloff(squares, position.w) * fbrdfConeFactor(fbrdfLights[3 * i + 2], wi));
            sum += weight * peerBrdf(wi, NoL);
        }
    }
    fbrdfColour = vec4(NoV > 0.0 ? sum : vec3(0.0), 1.0);
}
