// A right-handed frame whose z is the axis. Twin: lobeFrame, Prefilter.h. Duff et al. 2017, "Building an Orthonormal
// Basis, Revisited", Listing 3.
mat3 fbrdfLobeFrame(vec3 axis)
{
    float side = axis.z < 0.0 ? -1.0 : 1.0;
    float a = -1.0 / (side + axis.z), b = axis.x * axis.y * a;
    return mat3(1.0 + side * axis.x * axis.x * a, side * b, -side * axis.x,
                b, side + axis.y * axis.y * a, -axis.y, axis);
}
