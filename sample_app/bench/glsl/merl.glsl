// A MERL table (Matusik, Pfister, Brand, McMillan 2003) as a 3D texture, x = phi_d, y = theta_d, z = theta_h: cell
// centres at sqrt(theta_h / 90 degrees), theta_d / 90 degrees, phi_d / 180 degrees; phi_d repeats.
uniform sampler3D peerTable;

void peerView(FbrdfShadingFrame frame, vec3 wo, float NoV)
{
    peerRemember(frame.n, wo, NoV);
}

vec3 peerBrdf(vec3 wi, float NoL)
{
    const float kPi = 3.14159265358979;
    PeerAngles a = peerAngles(wi, NoL);
    float theta_h = atan(a.sinTheta_h, a.cosTheta_h), theta_d = acos(min(a.d.z, 1.0)), phi_d = atan(a.d.y, a.d.x);
    return textureLod(peerTable, vec3(phi_d / kPi, theta_d * (2.0 / kPi), sqrt(theta_h * (2.0 / kPi))), 0.0).rgb;
}
