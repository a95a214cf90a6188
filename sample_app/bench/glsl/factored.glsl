// p(wo) q(h) p(wi) of 2001 with all three factors in the pass of each light, as an effect with one pass per light does.
// peerParameters: (lower of p, size), (extent of p, radius), (lower of q, size), (extent of q, radius), (scale, -).
uniform vec4 peerParameters[5];
uniform sampler2D peerMapP, peerMapQ;

FbrdfShadingFrame peerFrame;
vec3 peerWo;

vec2 peerPosition(int map, vec3 w)
{
    float size = peerParameters[2 * map].w;
    return (fbrdfDiscPosition(size, 0.5, peerParameters[2 * map + 1].w, w) + 0.5) / size;
}

void peerView(FbrdfShadingFrame frame, vec3 wo, float NoV)
{
    peerFrame = frame;
    peerWo = fbrdfLocal(frame, wo);
}

vec3 peerBrdf(vec3 toLight, float NoL)
{
    vec3 wi = fbrdfLocal(peerFrame, toLight);
    vec3 p = textureLod(peerMapP, peerPosition(0, wi), 0.0).rgb + textureLod(peerMapP, peerPosition(0, peerWo), 0.0).rgb;
    vec3 q = textureLod(peerMapQ, peerPosition(1, fbrdfHalfVector(peerWo, wi)), 0.0).rgb;
    return peerParameters[4].rgb * exp2(2.0 * peerParameters[0].rgb + peerParameters[1].rgb * p +
                                        peerParameters[2].rgb + peerParameters[3].rgb * q);
}
