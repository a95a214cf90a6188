// The local frame of a shaded point. Twin: ShadingFrame.h.
struct FbrdfFrame {
    vec3 t, s, n;
};

FbrdfFrame fbrdfFrame(vec3 normal, vec3 tangent)
{
    vec3 n = normalize(normal);
    vec3 t = tangent - n * dot(n, tangent);
    if (!(dot(t, t) > 1e-10 * dot(tangent, tangent))) {
        vec3 axis = abs(n.x) < 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
        t = axis - n * dot(n, axis);
    }
    t = normalize(t);
    return FbrdfFrame(t, cross(n, t), n);
}

vec3 fbrdfLocal(FbrdfFrame frame, vec3 w)
{
    return vec3(dot(frame.t, w), dot(frame.s, w), dot(frame.n, w));
}
