// The square around the ground, from the vertex number alone. The plane of Ground.h: x to the right, and z towards the
// viewer of the picture, in radii from its centre.
#version 330 core
uniform mat4 clipFromGround;
out vec2 place;

void main()
{
    place = 2.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1) - 1.0;
    gl_Position = clipFromGround * vec4(place.x, 0.0, place.y, 1.0);
}
