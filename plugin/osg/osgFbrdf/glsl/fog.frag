// OpenGL's fog over what all passes left: blended as colour + alpha x destination. OpenGL 2.1 specification, section
// 3.10; the distance is that along the view axis, or with `radial` that to the eye (NV_fog_distance).
FBRDF_FROM_VERTEX vec3 fbrdfPosition;
FBRDF_COLOUR_OUTPUT
uniform vec3 osgFbrdfFogColour;
uniform vec3 osgFbrdfFogRange;  // density, start, end
uniform int osgFbrdfFogMode;    // 0 linear, 1 exp, 2 exp2
uniform bool osgFbrdfFogRadial;

void main()
{
    float way = osgFbrdfFogRadial ? length(fbrdfPosition) : abs(fbrdfPosition.z);
    float depth = osgFbrdfFogRange.x * way;
    float through = osgFbrdfFogMode == 0 ? (osgFbrdfFogRange.z - way) / (osgFbrdfFogRange.z - osgFbrdfFogRange.y)
                                         : exp(osgFbrdfFogMode == 1 ? -depth : -depth * depth);
    through = clamp(through, 0.0, 1.0);
    fbrdfColour = vec4((1.0 - through) * osgFbrdfFogColour, through);
}
