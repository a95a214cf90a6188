FBRDF_ATTRIBUTE vec3 fbrdfVertex;

void main()
{
    gl_Position = vec4(fbrdfVertex, 1.0);
}
