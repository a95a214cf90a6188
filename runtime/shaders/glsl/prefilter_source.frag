// A texel of the cube that is convolved later: the mean of its environment over the texel. FBRDF_FROM_CUBE: from a cube
// map, else from a picture of latitude and longitude.
#ifdef FBRDF_FROM_CUBE
uniform samplerCube fbrdfRadiance;
#else
uniform sampler2D fbrdfRadiance;
#endif
#if __VERSION__ >= 130
#define FBRDF_SOURCE_SIZE vec2(textureSize(fbrdfRadiance, 0))
#else
uniform vec2 fbrdfSourceSize;
#define FBRDF_SOURCE_SIZE fbrdfSourceSize
#endif

// The sum of radiance times weight, and of the weight.
vec4 fbrdfWeighted(vec3 radiance, float weight)
{
    return weight * vec4(fbrdfStorable(radiance), 1.0);
}

#ifdef FBRDF_FROM_CUBE
// A linear filter is a box of one texel, wherever it is: there are as many look-ups as texels of the source.
vec4 fbrdfTexelSum(vec2 corner)
{
    float cells = clamp(ceil(FBRDF_SOURCE_SIZE.x / fbrdfFaceSize), 1.0, 16.0);
    vec4 sum = vec4(0.0);
    for (float y = 0.5; y < cells; y += 1.0)
        for (float x = 0.5; x < cells; x += 1.0) {
            vec3 point = fbrdfFacePoint(corner + vec2(x, y) / cells);
            float squared = dot(point, point);
            sum += fbrdfWeighted(FBRDF_TEXTURE_CUBE_LEVEL(fbrdfRadiance, point, 0.0).rgb, inversesqrt(squared) / squared);
        }
    return sum;
}
#else
// The method of cubeOfPanorama, CubeOfPanorama.cpp: meridians are straight lines on all faces. Light is integrated along
// each within one column of the picture, exactly, and between meridians by the midpoint rule. What one texel does not
// get of a small lamp the next one gets.

// Along a meridian of a column, between two places in rows from +y.
vec4 fbrdfAlongMeridian(float column, float top, float bottom)
{
    vec2 size = FBRDF_SOURCE_SIZE;
    float x = (column - size.x * floor((column + 0.5) / size.x) + 0.5) / size.x, halfRow = 1.57079633 / size.y;
    vec4 sum = vec4(0.0);
    for (float y = min(floor(top), size.y - 1.0); y < min(bottom, size.y); y += 1.0) {
        float from = max(top, y), to = min(bottom, y + 1.0);
        // cos a - cos b: no digits are lost at the poles.
        float zone = 2.0 * sin(halfRow * (from + to)) * sin(halfRow * (to - from));
        sum += fbrdfWeighted(FBRDF_TEXTURE2_LEVEL(fbrdfRadiance, vec2(x, (y + 0.5) / size.y), 0.0).rgb, zone);
    }
    return sum;
}

// Row of a direction that is `up` above the horizon for each unit away from the axis.
float fbrdfRowOf(float away, float up)
{
    return atan(away, up) / 3.14159265 * FBRDF_SOURCE_SIZE.y;
}

// A side: columns of texels are between meridians. s runs against the azimuth, t downwards.
vec4 fbrdfSideSum(vec2 low, vec2 high)
{
    float columns = FBRDF_SOURCE_SIZE.x / 6.28318531, centre = atan(fbrdfFace[2].x, -fbrdfFace[2].z);
    float first = columns * (3.14159265 + centre - atan(high.x)), last = columns * (3.14159265 + centre - atan(low.x));
    // As on the CPU: half a texel, and 0.02 radians.
    float step = columns * min(0.02, 0.785398163 / fbrdfFaceSize);
    vec4 sum = vec4(0.0);
    for (float column = floor(first); column < last; column += 1.0) {
        float from = max(first, column), width = min(last, column + 1.0) - from, steps = ceil(width / step);
        for (float i = 0.5; i < steps; i += 1.0) {
            float across = cos((from + width * i / steps) / columns - 3.14159265 - centre);
            sum += width / steps *
                   fbrdfAlongMeridian(column, fbrdfRowOf(1.0, -low.y * across), fbrdfRowOf(1.0, -high.y * across));
        }
    }
    return sum;
}

// The azimuth of a point of the upper or lower face; GLSL leaves atan(0, 0) open.
float fbrdfCapAzimuth(vec2 point)
{
    return point == vec2(0.0) ? 0.0 : atan(point.x, -fbrdfFace[2].y * point.y);
}

// The upper or lower face: meridians are rays from its centre, the same for all texels, and so many that eight cross the
// texels at its corners. They are split where they leave a texel.
vec4 fbrdfCapSum(vec2 low, vec2 high)
{
    float rays = FBRDF_SOURCE_SIZE.x * ceil(36.0 * fbrdfFaceSize / FBRDF_SOURCE_SIZE.x);
    float middle = fbrdfCapAzimuth(0.5 * (low + high)), least = 0.0, most = 0.0;
    for (int i = 0; i < 4; ++i) {
        vec2 corner = vec2(i == 0 || i == 3 ? low.x : high.x, i < 2 ? low.y : high.y);
        if (corner == vec2(0.0)) continue;
        float turn = fbrdfCapAzimuth(corner) - middle;
        turn -= 6.28318531 * floor(turn / 6.28318531 + 0.5);
        least = min(least, turn);
        most = max(most, turn);
    }
    float perRadian = rays / 6.28318531;
    vec4 sum = vec4(0.0);
    for (float ray = floor((middle + least) * perRadian) + 0.5; ray < (middle + most) * perRadian + 1.0; ray += 1.0) {
        float azimuth = ray / perRadian;
        vec2 along = vec2(sin(azimuth), -fbrdfFace[2].y * cos(azimuth));
        // 1e-9 keeps a ray along an axis from dividing by 0.
        along = vec2(abs(along.x) < 1e-9 ? 1e-9 : along.x, abs(along.y) < 1e-9 ? 1e-9 : along.y);
        vec2 one = low / along, other = high / along, enter = min(one, other), leave = max(one, other);
        float from = max(0.0, max(enter.x, enter.y)), to = min(leave.x, leave.y);
        if (!(to > from)) continue;
        float up = fbrdfFace[2].y, rowFrom = fbrdfRowOf(from, up), rowTo = fbrdfRowOf(to, up);
        float column = floor((azimuth / 6.28318531 + 0.5) * FBRDF_SOURCE_SIZE.x);
        sum += fbrdfAlongMeridian(column, min(rowFrom, rowTo), max(rowFrom, rowTo));
    }
    return sum;
}

vec4 fbrdfTexelSum(vec2 corner)
{
    vec2 low = 2.0 * corner / fbrdfFaceSize - 1.0, high = 2.0 * (corner + 1.0) / fbrdfFaceSize - 1.0;
    return fbrdfFace[2].y == 0.0 ? fbrdfSideSum(low, high) : fbrdfCapSum(low, high);
}
#endif

void main()
{
    vec4 sum = fbrdfTexelSum(floor(gl_FragCoord.xy));
    fbrdfColour = vec4(sum.rgb / max(sum.a, 1e-30), 1.0);
}
