// The tangent towards increasing s of the texture coordinates, by Cramer's rule from the differences to the neighbouring
// pixels, with the handedness of (s, t); 0 where (s, t) is constant. As in surface.glsl of the runtime, whose inputs are
// variables of the vertex shader.
vec4 vtkFbrdfDerivedTangent(vec2 st, vec3 position, vec3 normal)
{
    vec2 dx = dFdx(st), dy = dFdy(st);
    vec3 px = dFdx(position), py = dFdy(position);
    float facing = sign(dx.s * dy.t - dx.t * dy.s);
    vec3 alongS = facing * (px * dy.t - py * dx.t), alongT = facing * (py * dx.s - px * dy.s);
    return vec4(alongS, dot(cross(normal, alongS), alongT));
}
