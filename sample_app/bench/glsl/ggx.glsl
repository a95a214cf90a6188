// GGX with anisotropic roughness, height-correlated Smith masking, Schlick Fresnel, over a Lambertian: the model `ggx`.
// Heitz 2014, "Understanding the Masking-Shadowing Function", Eq. 85, 72 and 99, in the form without tangents:
//   f = kd / pi + F D / (4 NoL NoV (1 + L_o + L_i)) = kd / pi + F D / (2 (NoL |o| + NoV |i|)),
//   |w| = sqrt((alpha_x w.t)^2 + (alpha_y w.s)^2 + (w.n)^2).
// peerParameters: (alpha_x, alpha_y, 1 / alpha_x, 1 / alpha_y), (f0, -), (kd / pi, -).
uniform vec4 peerParameters[3];

vec3 peerTangent, peerBitangent, peerNormal, peerWo;
float peerNoV, peerViewLength, peerScale;

float peerLength(float t, float s, float n)
{
    vec2 st = peerParameters[0].xy * vec2(t, s);
    return sqrt(dot(st, st) + n * n);
}

void peerView(FbrdfShadingFrame frame, vec3 wo, float NoV)
{
    peerTangent = frame.t;
    peerBitangent = frame.s;
    peerNormal = frame.n;
    peerWo = wo;
    peerNoV = NoV;
    peerViewLength = peerLength(dot(frame.t, wo), dot(frame.s, wo), NoV);
    peerScale = 0.5 * peerParameters[0].z * peerParameters[0].w / 3.14159265358979;
}

vec3 peerBrdf(vec3 wi, float NoL)
{
    vec3 h = wi + peerWo;
    float inverseSquare = 1.0 / dot(h, h);  // h is not normalised: only squares of h / |h| are needed
    float LoH = 0.5 * inversesqrt(inverseSquare);
    vec2 slope = peerParameters[0].zw * vec2(dot(peerTangent, h), dot(peerBitangent, h));
    float NoH = NoL + peerNoV;
    float d = (dot(slope, slope) + NoH * NoH) * inverseSquare;
    float lightLength = peerLength(dot(peerTangent, wi), dot(peerBitangent, wi), NoL);
    float reflection = peerScale / (d * d * (NoL * peerViewLength + peerNoV * lightLength));
    float c = 1.0 - LoH, c2 = c * c;
    vec3 f0 = peerParameters[1].rgb;
    vec3 fresnel = f0 + (1.0 - f0) * (c2 * c2 * c);
    return peerParameters[2].rgb + fresnel * reflection;
}
