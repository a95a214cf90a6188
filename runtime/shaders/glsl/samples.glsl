// Directions of an environment for a fragment, and how finely each is looked up.

// Point of a lattice: (number of points, step). Twin: samplePoint, SampleLattice.h. A quotient is floored half a step
// away from whole numbers, for division need not be exact.
vec2 fbrdfSamplePoint(float index, vec2 lattice)
{
    float turned = index * lattice.y;
    return vec2((index + 0.5) / lattice.x, (turned - lattice.x * floor((turned + 0.5) / lattice.x) + 0.5) / lattice.x);
}

// The level of a cube, of `size` texels on a side of a face, whose texels are as large as a cell. Twin: levelOfCell,
// Prefilter.h.
float fbrdfLevelOfCell(float solidAngle, vec3 direction, float size)
{
    vec3 across = abs(direction);
    return 0.5 * log2(0.25 * solidAngle * size * size) - 1.5 * log2(max(across.x, max(across.y, across.z)));
}
