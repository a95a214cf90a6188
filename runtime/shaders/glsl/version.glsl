// What differs between GLSL 1.20, 1.40 to 4.50, ES 1.00 and ES 3.00. Textures but those of environments have one level,
// so the explicit level of textureLod changes nothing but spares the derivatives. In GLSL 1.20 textureCubeLod needs
// GL_ARB_shader_texture_lod.
#if defined(GL_ES) && !defined(GL_FRAGMENT_PRECISION_HIGH)
#error fbrdf needs highp floats in fragment shaders
#endif
#ifdef GL_ES
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp samplerCube;
#endif
#if defined(GL_ES) && __VERSION__ >= 300
precision highp sampler3D;
#endif
#if __VERSION__ >= 130
#define FBRDF_ATTRIBUTE in
#define FBRDF_TO_FRAGMENT out
#define FBRDF_FROM_VERTEX in
#define FBRDF_COLOUR_OUTPUT out vec4 fbrdfColour;
#define FBRDF_TEXTURE2(map, coordinate) textureLod(map, coordinate, 0.0)
#define FBRDF_TEXTURE3(map, coordinate) textureLod(map, coordinate, 0.0)
#define FBRDF_TEXTURE_CUBE(map, direction) textureLod(map, direction, 0.0)
#define FBRDF_TEXTURE_MIPMAPPED(map, coordinate) texture(map, coordinate)
#define FBRDF_TEXTURE2_LEVEL(map, coordinate, level) textureLod(map, coordinate, level)
#define FBRDF_TEXTURE_CUBE_LEVEL(map, direction, level) textureLod(map, direction, level)
#else
#define FBRDF_ATTRIBUTE attribute
#define FBRDF_TO_FRAGMENT varying
#define FBRDF_FROM_VERTEX varying
#define FBRDF_COLOUR_OUTPUT
#define fbrdfColour gl_FragColor
#define FBRDF_TEXTURE2(map, coordinate) texture2D(map, coordinate)
#define FBRDF_TEXTURE3(map, coordinate) texture3D(map, coordinate)
#define FBRDF_TEXTURE_CUBE(map, direction) textureCube(map, direction)
#define FBRDF_TEXTURE_MIPMAPPED(map, coordinate) texture2D(map, coordinate)
#define FBRDF_TEXTURE2_LEVEL(map, coordinate, level) texture2DLod(map, coordinate, level)
#define FBRDF_TEXTURE_CUBE_LEVEL(map, direction, level) textureCubeLod(map, direction, level)
#endif
#define FBRDF_TEXTURE_PRECISE fbrdfFiltered
