// The diffuse light of OpenGL's fixed function, at each vertex, for contexts that have none: OpenGL 2.1 specification,
// section 2.14.1, without specular light. Five vectors describe a light in eye space:
//   place        where it is; w = 0: a direction to it
//   diffuse      w: the exponent of a cone
//   ambient      w: the cosine at the edge of the cone; -1: none
//   coefficients constant, linear, quadratic
//   axis         unit, where a cone shines
invariant gl_Position;

uniform vec4 osgFbrdfDiffuseLights[5 * 8];
uniform int osgFbrdfDiffuseLightCount;
uniform vec3 osgFbrdfAlbedo;   // of diffuse light
uniform vec3 osgFbrdfAmbient;  // of ambient light, which is osgFbrdfSurrounding beside that of the lights
uniform vec3 osgFbrdfSurrounding;
FBRDF_TO_FRAGMENT vec4 osgFbrdfDiffuse;

// How much of light i arrives at a position; toLight: unit, towards it.
float osgFbrdfArrives(int i, vec3 position, out vec3 toLight)
{
    vec4 place = osgFbrdfDiffuseLights[5 * i];
    toLight = normalize(place.xyz - place.w * position);
    if (place.w == 0.0) return 1.0;
    float way = distance(place.xyz, position);
    float divisor = dot(osgFbrdfDiffuseLights[5 * i + 3].xyz, vec3(1.0, way, way * way));
    float edge = osgFbrdfDiffuseLights[5 * i + 2].w, exponent = osgFbrdfDiffuseLights[5 * i + 1].w;
    if (edge < 0.0) return 1.0 / divisor;
    float cosine = max(-dot(osgFbrdfDiffuseLights[5 * i + 4].xyz, toLight), 0.0);
    if (cosine < edge) return 0.0;
    return (exponent > 0.0 ? pow(cosine, exponent) : 1.0) / divisor;
}

void main()
{
    mat4 modelView = fbrdfModelViewMatrix();
    vec4 position = modelView * FBRDF_VERTEX;
    vec3 normal = normalize(transpose(inverse(mat3(modelView))) * fbrdfVertexNormal);
    vec3 colour = osgFbrdfAmbient * osgFbrdfSurrounding;
    for (int i = 0; i < osgFbrdfDiffuseLightCount; ++i) {
        vec3 toLight;
        float arrives = osgFbrdfArrives(i, position.xyz, toLight);
        vec3 diffuse = osgFbrdfAlbedo * osgFbrdfDiffuseLights[5 * i + 1].rgb * max(dot(normal, toLight), 0.0);
        colour += arrives * (diffuse + osgFbrdfAmbient * osgFbrdfDiffuseLights[5 * i + 2].rgb);
    }
    osgFbrdfDiffuse = vec4(clamp(colour, 0.0, 1.0), 1.0);
    FBRDF_CLIP(position)
    gl_Position = fbrdfProjection * position;
}
