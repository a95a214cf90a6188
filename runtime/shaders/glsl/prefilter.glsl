// What the programs share that make the cube map of an environment (Prefilter.h), one face of one level after another.
uniform mat3 fbrdfFace;         // columns: directions of increasing s and t, and the centre of the face
uniform float fbrdfFaceSize;    // texels on a side
uniform float fbrdfLargest;     // what the format of the face can store
FBRDF_COLOUR_OUTPUT

// A point of the face, not unit; position: in texels from its corner.
vec3 fbrdfFacePoint(vec2 position)
{
    return fbrdfFace * vec3(2.0 * position / fbrdfFaceSize - 1.0, 1.0);
}

// Negative numbers and those that are none count as 0.
vec3 fbrdfStorable(vec3 radiance)
{
    return vec3(radiance.r > 0.0 ? min(radiance.r, fbrdfLargest) : 0.0,
                radiance.g > 0.0 ? min(radiance.g, fbrdfLargest) : 0.0,
                radiance.b > 0.0 ? min(radiance.b, fbrdfLargest) : 0.0);
}
