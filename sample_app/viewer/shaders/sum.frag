// One sample of every pixel, to be added to the others.
#version 330 core
uniform sampler2D drawn;
out vec4 color;

void main()
{
    color = texelFetch(drawn, ivec2(gl_FragCoord.xy), 0);
}
