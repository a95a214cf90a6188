// One triangle that covers the window, from the vertex number alone.
#version 330 core
out vec2 coordinate;

void main()
{
    coordinate = 2.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(2.0 * coordinate - 1.0, 0.0, 1.0);
}
