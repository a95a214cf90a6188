// Rusinkiewicz' angles of a pair without a tangent frame: phi_h does not matter to isotropic peers.
// With l = |wi + wo|: cos theta_d = l / 2, cos theta_h = (n.wi + n.wo) / l, and in the frame whose pole is h and whose x
// axis lies in the plane of n and h: wi = ((cos theta_d cos theta_h - n.wi) / sin theta_h,
// (n x wo).wi / (l sin theta_h), cos theta_d).
vec3 peerWo, peerCross;
float peerNoV;

void peerRemember(vec3 n, vec3 wo, float NoV)
{
    peerWo = wo;
    peerNoV = NoV;
    peerCross = cross(n, wo);
}

struct PeerAngles {
    float cosTheta_h, sinTheta_h;
    vec3 d;
};

PeerAngles peerAngles(vec3 wi, float NoL)
{
    vec3 sum = wi + peerWo;
    float inverseLength = inversesqrt(max(dot(sum, sum), 1e-12));
    float cosTheta_d = 0.5 / inverseLength;
    float cosTheta_h = min((NoL + peerNoV) * inverseLength, 1.0);
    float sinTheta_h = sqrt(max(1.0 - cosTheta_h * cosTheta_h, 1e-12));
    float inverseSine = 1.0 / sinTheta_h;
    return PeerAngles(cosTheta_h, sinTheta_h,
                      vec3((cosTheta_d * cosTheta_h - NoL) * inverseSine,
                           dot(peerCross, wi) * inverseLength * inverseSine, cosTheta_d));
}
