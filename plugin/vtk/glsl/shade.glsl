// What a fragment of a vtkActor stores of the radiance that it reflects.
uniform vec4 fbrdfEye;  // eyeFromProjection, ShaderSource.h
uniform int vtkFbrdfTransfer;  // 0 linear, 1 srgb, 2 tone-map

// VTK turns the normals of back faces round. At the silhouette of a smooth mesh some of them face the viewer already.
// Lines and points have no back face: their normals always turn to the viewer.
vec3 vtkFbrdfFacing(vec3 normal, vec3 viewer, bool isFace)
{
    return !(isFace && gl_FrontFacing) && dot(normal, viewer) < 0.0 ? -normal : normal;
}

vec3 vtkFbrdfShaded(vec3 position, vec3 normal, vec4 tangent, bool isFace)
{
    vec3 viewer = normalize(fbrdfEye.xyz - fbrdfEye.w * position);
    vec3 value = fbrdfRadiance(position, vtkFbrdfFacing(normal, viewer, isFace), tangent, viewer);
    if (vtkFbrdfTransfer == 2) value = fbrdfToneMapped(value);
    return vtkFbrdfTransfer == 0 ? value : fbrdfSrgbFromLinear(min(value, vec3(1.0)));
}
