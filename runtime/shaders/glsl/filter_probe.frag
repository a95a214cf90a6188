// How far a filter is from the line between two texels; ShaderSource.h says what it is given and
// returns.
uniform vec2 fbrdfRamp;
FBRDF_COLOUR_OUTPUT

void main()
{
    // 1021 is prime: places fall everywhere between the steps of a filter, whose number is a power
    // of two.
    float worst = 0.0;
    for (int i = 0; i < 1021; ++i) {
        float weight = (float(i) + 0.5) / 1021.0;
        vec3 error =
            abs(FBRDF_PROBE(vec3(0.25 + 0.5 * weight)).rgb - mix(fbrdfRamp.x, fbrdfRamp.y, weight));
        worst = max(worst, max(error.x, max(error.y, error.z)));
    }
    float bytes = 255.0 * clamp(-log2(max(worst, 1e-9)) / 32.0, 0.0, 1.0);
    fbrdfColour = vec4(floor(bytes) / 255.0, fract(bytes), 1.0, 1.0);
}
