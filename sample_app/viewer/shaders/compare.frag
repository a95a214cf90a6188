// Two pictures as they are shown, laid over each other. Twin: composed in ComparePicture.h, but for labels.
#version 330 core
uniform sampler2D a, b;
uniform int mode;            // 0: A to the left of the line and B to the right, 1: A, 2: B, 3: difference, 4: heat
uniform float line;          // pixels to the left of it
uniform float gain;          // of the difference
uniform float hottest;       // difference that has the last of the colours
uniform vec3 stops[5];       // of heat, linear
out vec4 color;

vec3 srgbFromLinear(vec3 x)
{
    vec3 curve = 1.055 * pow(max(x, 0.0031308), vec3(1.0 / 2.4)) - 0.055;
    return mix(12.92 * x, curve, step(0.0031308, x));
}

// Twin: heatColour in HeatScale.h.
vec3 heatColour(float share)
{
    float place = 4.0 * clamp(share, 0.0, 1.0);
    int first = min(int(place), 3);
    return mix(stops[first], stops[first + 1], place - float(first));
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 left = texelFetch(a, pixel, 0).rgb, right = texelFetch(b, pixel, 0).rgb;
    vec3 off = abs(left - right);
    if (mode == 0) color.rgb = gl_FragCoord.x < line ? left : right;
    if (mode == 1) color.rgb = left;
    if (mode == 2) color.rgb = right;
    if (mode == 3) color.rgb = min(vec3(1.0), gain * off);
    if (mode == 4) color.rgb = srgbFromLinear(heatColour(max(off.r, max(off.g, off.b)) / hottest));
    color.a = 1.0;
}
