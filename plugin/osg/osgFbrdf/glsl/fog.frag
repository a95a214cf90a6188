#version 120
// OpenGL's fog over what all passes left: blended as colour + alpha x destination. OpenGL 2.1 specification, section
// 3.10; the distance is that along the view axis, or with `radial` that to the eye (NV_fog_distance).
varying vec3 fbrdfPosition;
uniform int osgFbrdfFogMode;  // 0 linear, 1 exp, 2 exp2
uniform bool osgFbrdfFogRadial;

void main()
{
    float way = osgFbrdfFogRadial ? length(fbrdfPosition) : abs(fbrdfPosition.z);
    float depth = gl_Fog.density * way;
    float through = osgFbrdfFogMode == 0 ? (gl_Fog.end - way) * gl_Fog.scale
                                         : exp(osgFbrdfFogMode == 1 ? -depth : -depth * depth);
    through = clamp(through, 0.0, 1.0);
    gl_FragColor = vec4((1.0 - through) * gl_Fog.color.rgb, through);
}
