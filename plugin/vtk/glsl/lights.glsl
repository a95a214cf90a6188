// The lights of a vtkRenderer, in rows of 256 texels: the three vectors of each light (LightVectors.h), then for each of
// the first vtkFbrdfAttenuated lights its constant, linear and quadratic attenuation and the exponent of its cone.
uniform sampler2D vtkFbrdfLights;
uniform int vtkFbrdfAttenuated;

vec4 fbrdfLightVector(int index)
{
    return texelFetch(vtkFbrdfLights, ivec2(index & 255, index >> 8), 0);
}
