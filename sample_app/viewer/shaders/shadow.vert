// Objects as a light sees them.
#version 330 core
layout(location = 0) in vec3 position;
uniform mat4 clipFromObject;

void main()
{
    gl_Position = clipFromObject * vec4(position, 1.0);
}
