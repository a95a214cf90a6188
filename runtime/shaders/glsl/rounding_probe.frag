// Values that a target has to round, no two alike; ShaderSource.h says which.
uniform vec2 fbrdfRamp;
FBRDF_COLOUR_OUTPUT

void main()
{
    vec2 at = floor(gl_FragCoord.xy);
    vec3 index = 4.0 * (64.0 * at.y + at.x) + vec3(1.0, 2.0, 3.0);
    fbrdfColour = vec4(fbrdfRamp.x + fbrdfRamp.y * (511.0 * index / 8388608.0), 1.0);
}
