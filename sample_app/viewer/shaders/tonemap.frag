// Linear radiance to the window: exposure, then sRGB (IEC 61966-2-1) as in the PNG of Image.h; where
// nothing was drawn, a backdrop that gets darker towards the edges.
#version 330 core
uniform sampler2D radiance;
uniform float exposure;
uniform float topDown;  // 1 when row 0 of the texture is the top one
in vec2 coordinate;
out vec4 color;

vec3 srgbFromLinear(vec3 x)
{
    vec3 curve = 1.055 * pow(max(x, 0.0031308), vec3(1.0 / 2.4)) - 0.055;
    return mix(12.92 * x, curve, step(0.0031308, x));
}

void main()
{
    vec2 uv = vec2(coordinate.x, mix(coordinate.y, 1.0 - coordinate.y, topDown));
    vec4 texel = texture(radiance, uv);
    vec2 fromCentre = coordinate - vec2(0.5, 0.55);
    vec3 backdrop = vec3(0.024, 0.026, 0.030) * (1.25 - 1.6 * dot(fromCentre, fromCentre));
    vec3 linear = mix(backdrop, exposure * texel.rgb, clamp(texel.a, 0.0, 1.0));
    color = vec4(srgbFromLinear(clamp(linear, 0.0, 1.0)), 1.0);
}
