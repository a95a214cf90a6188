// The share of a light that arrives by a shadow map: one comparison of depths, as fine as the texture filters.
// coordinate: of the point in the map, homogeneous.
#if __VERSION__ >= 130
#define OSGFBRDF_COMPARED(map, coordinate) textureProj(map, coordinate)
#else
#define OSGFBRDF_COMPARED(map, coordinate) shadow2DProj(map, coordinate).r
#endif

// Behind the place that a map is drawn from it has no shadows.
float osgFbrdfPlain(sampler2DShadow map, vec4 coordinate)
{
    return coordinate.q > 0.0 ? OSGFBRDF_COMPARED(map, coordinate) : 1.0;
}
