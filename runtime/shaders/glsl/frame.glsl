// The local frame of a shaded point. Twin: ShadingFrame.h.
struct FbrdfShadingFrame {
    vec3 t, s, n;
};

// tangent.w: handedness, negative where s = -n x t. 1e-10 is the square of what rounding leaves of a tangent that is
// parallel to the normal, relative to its length.
FbrdfShadingFrame fbrdfShadingFrame(vec3 normal, vec4 tangent)
{
    vec3 n = normalize(normal);
    vec3 t = tangent.xyz - n * dot(n, tangent.xyz);
    if (!(dot(t, t) > 1e-10 * dot(tangent.xyz, tangent.xyz))) {
        vec3 axis = abs(n.x) < 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
        t = axis - n * dot(n, axis);
    }
    t = normalize(t);
    return FbrdfShadingFrame(t, tangent.w < 0.0 ? cross(t, n) : cross(n, t), n);
}

FbrdfShadingFrame fbrdfShadingFrame(vec3 normal, vec3 tangent)
{
    return fbrdfShadingFrame(normal, vec4(tangent, 1.0));
}

// The frame about a normal that is given in the coordinates of another frame, as a normal map stores it; 0 changes
// nothing.
FbrdfShadingFrame fbrdfPerturbed(FbrdfShadingFrame frame, vec3 normal)
{
    if (!(dot(normal, normal) > 0.0)) return frame;
    float handedness = dot(cross(frame.n, frame.t), frame.s);
    return fbrdfShadingFrame(frame.t * normal.x + frame.s * normal.y + frame.n * normal.z, vec4(frame.t, handedness));
}

vec3 fbrdfLocal(FbrdfShadingFrame frame, vec3 w)
{
    return vec3(dot(frame.t, w), dot(frame.s, w), dot(frame.n, w));
}

vec3 fbrdfFromLocal(FbrdfShadingFrame frame, vec3 w)
{
    return frame.t * w.x + frame.s * w.y + frame.n * w.z;
}
