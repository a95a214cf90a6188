// Linear radiance to the window: what is behind the objects, exposure, the curve of tone mapping, and sRGB (IEC
// 61966-2-1), as in the PNG of Image.h.
#version 330 core
uniform sampler2D radiance;  // a sum of pictures
uniform float share;         // of one of them: 1 / their number
uniform float topDown;       // 1 when row 0 of the texture is the top one
uniform float exposure;
uniform bool curved;         // Transfer::toneMap instead of Transfer::srgb
uniform int behind;          // 0: a backdrop that gets darker towards the edges, 1: a colour, 2: the panorama
uniform vec3 colour;
uniform sampler2D panorama;
uniform mat4 worldFromClip;
uniform vec3 turn;           // cosine and sine of the panorama's rotation, and its intensity
in vec2 coordinate;
out vec4 color;

const float kPi = 3.14159265;

vec3 srgbFromLinear(vec3 x)
{
    vec3 curve = 1.055 * pow(max(x, 0.0031308), vec3(1.0 / 2.4)) - 0.055;
    return mix(12.92 * x, curve, step(0.0031308, x));
}

// Twin: toneMapped in Transfer.h.
vec3 toneMapped(vec3 x)
{
    return min(vec3(1.0), x * (1.0 + x / 16.0) / (1.0 + x));
}

vec3 unprojected(float depth)
{
    vec4 point = worldFromClip * vec4(2.0 * coordinate - 1.0, depth, 1.0);
    return point.xyz / point.w;
}

// Twin: EnvironmentLight::radianceFrom.
vec3 radianceFrom(vec3 world)
{
    vec3 w = vec3(turn.x * world.x - turn.y * world.z, world.y, turn.y * world.x + turn.x * world.z);
    vec2 place = vec2(0.5 + atan(w.x, -w.z) / (2.0 * kPi), atan(length(w.xz), w.y) / kPi);
    return turn.z * textureLod(panorama, place, 0.0).rgb;
}

// Radiance behind the objects.
vec3 background()
{
    if (behind == 1) return colour;
    return radianceFrom(unprojected(0.5) - unprojected(-0.5));
}

void main()
{
    vec2 uv = vec2(coordinate.x, mix(coordinate.y, 1.0 - coordinate.y, topDown));
    vec4 texel = share * texture(radiance, uv);
    float open = 1.0 - clamp(texel.a, 0.0, 1.0);
    vec2 fromCentre = coordinate - vec2(0.5, 0.55);
    // The backdrop is there for the eye alone: no exposure changes it.
    vec3 backdrop = vec3(0.024, 0.026, 0.030) * (1.25 - 1.6 * dot(fromCentre, fromCentre));
    vec3 seen = exposure * (behind == 0 ? texel.rgb : texel.rgb + open * background());
    vec3 linear = (curved ? toneMapped(seen) : seen) + (behind == 0 ? open * backdrop : vec3(0.0));
    color = vec4(srgbFromLinear(clamp(linear, 0.0, 1.0)), 1.0);
}
