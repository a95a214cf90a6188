// What the ground shows of the sky, and how much of the lit plane below it stays: blended as
// colour + alpha x what is there.
#version 330 core
uniform sampler2D visibility;  // of the sky (SkyVisibility)
uniform vec3 openSky;          // what an open ground reflects of it
uniform float opaque;          // Ground::kOpaque
in vec2 place;
out vec4 color;

// Twin: Ground::opacity.
float groundOpacity(float distance)
{
    return 1.0 - smoothstep(opaque, 1.0, distance);
}

void main()
{
    // Texel centres lie on [-1, 1], from the first to the last.
    float size = float(textureSize(visibility, 0).x);
    vec2 uv = (0.5 * (place + 1.0) * (size - 1.0) + 0.5) / size;
    float opacity = groundOpacity(length(place));
    color = vec4(opacity * texture(visibility, uv).r * openSky, opacity);
}
