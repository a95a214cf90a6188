// form io+pqpr, technique batched, 20 lights, GLSL ES 300
// pass  lights  look-ups  blend     writes        reads
//    1       8        25  replace   target        -
//    2       8        25  add       target        -
//    3       4        13  add       target        -

// ---- vertex shader, pass 1 to 3
#version 300 es
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

// Vertex inputs of a program that draws one object: attributes, and matrices in uniforms.
uniform mat4 fbrdfModelView;
uniform mat4 fbrdfProjection;
FBRDF_ATTRIBUTE vec3 fbrdfVertex;
FBRDF_ATTRIBUTE vec3 fbrdfVertexNormal;
#ifdef FBRDF_TEXTURE_COORDINATE
FBRDF_ATTRIBUTE vec2 fbrdfVertexTextureCoordinate;
#endif
#define FBRDF_VERTEX vec4(fbrdfVertex, 1.0)
#define FBRDF_CLIP(position)

mat4 fbrdfModelViewMatrix()
{
    return fbrdfModelView;
}
// The one vertex shader of all passes: later passes test depth for equality, so every pass must compute gl_Position by
// the same expression, and invariantly. One of the files inputs_*.glsl comes before it.
invariant gl_Position;

FBRDF_ATTRIBUTE vec4 fbrdfVertexTangent;  // w: handedness, which GL sets to 1 where the array has three components
#ifdef FBRDF_TEXTURE_COORDINATE
FBRDF_TO_FRAGMENT vec2 fbrdfTextureCoordinate;
#endif

// Eye space: float is finest near the eye, where it matters.
FBRDF_TO_FRAGMENT vec3 fbrdfPosition;
FBRDF_TO_FRAGMENT vec3 fbrdfNormal;
FBRDF_TO_FRAGMENT vec4 fbrdfTangent;

// A normal under the inverse transpose of m, by its cofactors. The host's own normal matrix is not used: engines round
// theirs in different ways, and near the terminator an ulp of a normal is visible.
vec3 fbrdfMovedNormal(mat3 m, vec3 n)
{
    vec3 yz = cross(m[1], m[2]), zx = cross(m[2], m[0]), xy = cross(m[0], m[1]);
    return (yz * n.x + zx * n.y + xy * n.z) / dot(m[0], yz);
}

void main()
{
    mat4 modelView = fbrdfModelViewMatrix();
    vec4 vertex = FBRDF_VERTEX, tangent = fbrdfVertexTangent;
    vec3 normal = fbrdfVertexNormal;
#ifdef FBRDF_VERTEX_HOOK
    fbrdfVertexHook(vertex.xyz, normal, tangent);
#endif
    vec4 position = modelView * vertex;
    mat3 turn = mat3(modelView[0].xyz, modelView[1].xyz, modelView[2].xyz);
    fbrdfPosition = position.xyz;
    fbrdfNormal = fbrdfMovedNormal(turn, normal);
    // A matrix that mirrors changes the frame's handedness.
    fbrdfTangent = vec4(turn * tangent.xyz, tangent.w * sign(dot(turn[0], cross(turn[1], turn[2]))));
#ifdef FBRDF_TEXTURE_COORDINATE
    fbrdfTextureCoordinate = fbrdfVertexTextureCoordinate;
#endif
    FBRDF_CLIP(position)
    gl_Position = fbrdfProjection * position;
}

// ---- fragment shader, pass 1 to 3
#version 300 es
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
// The shaded point, in eye space, interpolated from what surface.vert wrote.
FBRDF_FROM_VERTEX vec3 fbrdfPosition;
FBRDF_FROM_VERTEX vec3 fbrdfNormal;
#ifdef FBRDF_INSTANCED
flat FBRDF_FROM_VERTEX int fbrdfMaterial;
#endif
#ifndef FBRDF_DERIVED_TANGENT
FBRDF_FROM_VERTEX vec4 fbrdfTangent;
#endif
#ifdef FBRDF_TEXTURE_COORDINATE
FBRDF_FROM_VERTEX vec2 fbrdfTextureCoordinate;
#endif
#ifdef FBRDF_NORMAL_MAP
uniform sampler2D fbrdfNormalMap;  // 2 texel - 1: the normal in the tangent frame
#endif
FBRDF_COLOUR_OUTPUT

uniform vec4 fbrdfEye;  // homogeneous: a point (w = 1), or the direction to it (w = 0) for a parallel projection

// Unit, from the shaded point to the viewer.
vec3 fbrdfToViewer()
{
    return normalize(fbrdfEye.xyz - fbrdfEye.w * fbrdfPosition);
}

#ifdef FBRDF_DERIVED_TANGENT
// The tangent towards increasing s, by Cramer's rule from the differences to the neighbouring pixels, with the
// handedness of (s, t); 0 where (s, t) is constant.
vec4 fbrdfDerivedTangent()
{
    vec2 dx = dFdx(fbrdfTextureCoordinate), dy = dFdy(fbrdfTextureCoordinate);
    vec3 px = dFdx(fbrdfPosition), py = dFdy(fbrdfPosition);
    float facing = sign(dx.s * dy.t - dx.t * dy.s);
    vec3 alongS = facing * (px * dy.t - py * dx.t), alongT = facing * (py * dx.s - px * dy.s);
    return vec4(alongS, dot(cross(fbrdfNormal, alongS), alongT));
}
#define fbrdfTangent fbrdfDerivedTangent()
#endif
// The local frame of a shaded point. Twin: ShadingFrame.h.
struct FbrdfShadingFrame {
    vec3 t, s, n;
};

// tangent.w: handedness, negative where s = -n x t. 1e-10 is the square of what rounding leaves of a tangent that is
// parallel to the normal, relative to its length.
FbrdfShadingFrame fbrdfShadingFrame(vec3 normal, vec4 tangent)
{
    vec3 n = normalize(normal);
    vec3 t = tangent.xyz - n * dot(n, tangent.xyz);
    if (!(dot(t, t) > 1e-10 * dot(tangent.xyz, tangent.xyz))) {
        vec3 axis = abs(n.x) < 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
        t = axis - n * dot(n, axis);
    }
    t = normalize(t);
    return FbrdfShadingFrame(t, tangent.w < 0.0 ? cross(t, n) : cross(n, t), n);
}

FbrdfShadingFrame fbrdfShadingFrame(vec3 normal, vec3 tangent)
{
    return fbrdfShadingFrame(normal, vec4(tangent, 1.0));
}

// The frame about a normal that is given in the coordinates of another frame, as a normal map stores it; 0 changes
// nothing.
FbrdfShadingFrame fbrdfPerturbed(FbrdfShadingFrame frame, vec3 normal)
{
    if (!(dot(normal, normal) > 0.0)) return frame;
    float handedness = dot(cross(frame.n, frame.t), frame.s);
    return fbrdfShadingFrame(frame.t * normal.x + frame.s * normal.y + frame.n * normal.z, vec4(frame.t, handedness));
}

vec3 fbrdfLocal(FbrdfShadingFrame frame, vec3 w)
{
    return vec3(dot(frame.t, w), dot(frame.s, w), dot(frame.n, w));
}

vec3 fbrdfFromLocal(FbrdfShadingFrame frame, vec3 w)
{
    return frame.t * w.x + frame.s * w.y + frame.n * w.z;
}
// Angles of a pair as (cosine, 1 - cosine), both in [0, 1] but for rounding. Twin: PairGeometry, Projection.h.

// 1 - cos = (sin^2 + (1 - cos)^2) / 2: the sine comes from where nothing cancels, and the rounding of 1 - cos counts times
// 1 - cos itself. It needs no division, of which a GPU does few. Samplers clamp what rounding leaves beyond 1.
vec2 fbrdfAngleFromCosine(float cosine, float sineSquared)
{
    float c = max(cosine, 0.0), complement = 1.0 - c;
    return vec2(c, 0.5 * (sineSquared + complement * complement));
}

// Zenith angle of a unit direction in the local frame: theta_i, theta_o, theta_h.
vec2 fbrdfZenith(vec3 w)
{
    return fbrdfAngleFromCosine(w.z, dot(w.xy, w.xy));
}

// The same about a unit normal in any frame: isotropic forms need no tangent.
vec2 fbrdfZenithAbout(vec3 n, vec3 w)
{
    vec3 sine = cross(n, w);
    return fbrdfAngleFromCosine(dot(n, w), dot(sine, sine));
}

// |both| and 1 / |both|, where both = wi + wo: with them theta_h, theta_d and phi_d need no half vector. 1e-30 is above
// the smallest normal float (1.2e-38), so that opposite directions give finite numbers.
vec2 fbrdfSizeOf(vec3 both)
{
    float square = dot(both, both), inverse = inversesqrt(max(square, 1e-30));
    return vec2(square * inverse, inverse);
}

// h = norm(wi + wo), or the normal where they are opposite.
vec3 fbrdfHalfVector(vec3 wo, vec3 wi)
{
    vec3 both = wi + wo;
    vec2 size = fbrdfSizeOf(both);
    return size.x > 0.0 ? both * size.y : vec3(0.0, 0.0, 1.0);
}

// theta_h about a normal n in any frame; across = n x both, height = n both; fbrdfAngleFromCosine, multiplied out.
vec2 fbrdfHalfZenith(float height, vec3 across, vec2 size)
{
    float above = max(height, 0.0), lacks = size.x - above;
    return vec2(above * size.y, 0.5 * size.y * size.y * (dot(across, across) + lacks * lacks));
}

// theta_d of a pair of unit directions, in any frame, from fbrdfSizeOf(wi + wo).x; fbrdfAngleFromCosine, multiplied out.
vec2 fbrdfDifferenceAngle(vec3 wo, vec3 wi, float size)
{
    vec3 apart = wi - wo;
    float lacks = 2.0 - size;
    return vec2(0.5 * size, 0.125 * (dot(apart, apart) + lacks * lacks));
}

// phi_d, folded to [0, pi/2], from the sides of the triangle whose angle it is, times |wi + wo|:
//     side = n (wo x wi),   lean = |wi + wo| (NoV - NoL) / 2.
vec2 fbrdfDifferenceAzimuth(float side, float lean)
{
    float square = side * side + lean * lean, inverse = inversesqrt(max(square, 1e-30));
    float across = side * inverse;
    return square > 0.0 ? fbrdfAngleFromCosine(abs(lean) * inverse, across * across) : vec2(0.0, 1.0);
}

// Half of a folded angle, or of pi less it: cos^2 of a half is (1 + cos) / 2, sin^2 is (1 - cos) / 2.
vec2 fbrdfHalfAngle(vec2 folded, bool isNear)
{
    vec2 squares = 0.5 * vec2(1.0 + folded.x, folded.y);
    if (!isNear) squares = squares.yx;
    return fbrdfAngleFromCosine(sqrt(squares.x), squares.y);
}

// phi_d / 2, phi_d in [0, pi] by the mirror symmetry.
vec2 fbrdfHalfDifferenceAzimuth(float side, float lean)
{
    return fbrdfHalfAngle(fbrdfDifferenceAzimuth(side, lean), lean >= 0.0);
}

// phi_d / 2, phi_d in [0, pi] by reciprocity.
vec2 fbrdfSideDifferenceAzimuth(float side, float lean)
{
    return fbrdfHalfAngle(fbrdfDifferenceAzimuth(side, lean), (lean >= 0.0) == (side >= 0.0));
}

// d: wi in the frame whose pole is h, in the local frame. Twin: differenceVector, Projection.h.
vec3 fbrdfDifferenceVector(vec3 h, vec3 wi)
{
    float square = dot(h.xy, h.xy), inverse = inversesqrt(max(square, 1e-30));
    vec2 toH = square > 0.0 ? h.xy * inverse : vec2(1.0, 0.0);
    return vec3(dot(wi, vec3(h.z * toH, -square * inverse)), toH.x * wi.y - toH.y * wi.x, dot(wi, h));
}

// norm(weights.x wo + weights.y wi + weights.z n), in the local frame. Twin: combination, Projection.h.
vec3 fbrdfCombination(vec3 weights, vec3 wo, vec3 wi)
{
    vec3 sum = weights.x * wo + weights.y * wi + vec3(0.0, 0.0, weights.z);
    float square = dot(sum, sum);
    return square > 0.0 ? sum * inversesqrt(max(square, 1e-30)) : vec3(0.0, 0.0, 1.0);
}
// Positions in tables. Twins: axisCoordinate and discPosition, Projection.h. Exponents are constants where these are
// called, so a compiler keeps one branch.

// u in [0, 1] of an angle given as cosine and 1 - cosine.
float fbrdfAxisCoordinate(bool fromCosine, float exponent, float cosine, float complement)
{
    float base = fromCosine ? cosine : complement;
    if (exponent == 1.0) return base;
    if (exponent == 0.5) return sqrt(base);
    if (exponent == 0.25) return sqrt(sqrt(base));
    return pow(base, exponent);
}

// Texel position of a direction of the upper hemisphere. With p = direction.xy / (1 + z) it is at p |p|^(gamma - 1). 1e-30
// is above the smallest normal float, so that the centre of the map is finite.
vec2 fbrdfDiscPosition(float size, float gamma, float radius, vec3 direction)
{
    float height = 1.0 + max(direction.z, 0.0), square = max(dot(direction.xy, direction.xy), 1e-30), scale;
    if (gamma == 0.5) scale = inversesqrt(height * sqrt(square));
    else if (gamma == 1.0) scale = 1.0 / height;
    else scale = pow(square, 0.5 * (gamma - 1.0)) * pow(height, -gamma);
    return vec2(0.5 * (size - 1.0)) + radius * scale * direction.xy;
}
// Light sources. A light is three vectors in eye space, see LightVectors.h:
//   position  a point, or for a directional light the unit direction towards it; and 1 / radius^2 (0: unlimited)
//   intensity and 1, or for a directional light 0
//   cone      axis x scale, offset; (0, 0, 0, 1) where there is none
// Directions are unit, so that one expression serves all kinds: branches cost more than the few products.

// Twin: influenceWindow, Light.h. Karis 2013, "Real Shading in Unreal Engine 4", Eq. 9.
float fbrdfInfluenceWindow(float distanceSquared, float inverseRadiusSquared)
{
    float ratio = distanceSquared * inverseRadiusSquared;
    float window = max(1.0 - ratio * ratio, 0.0);
    return window * window;
}

// Twin: falloff, Light.h. squares: squared distance and its inverse. As there, 1e12 keeps a light on the surface finite.
float fbrdfFalloff(vec2 squares, float inverseRadiusSquared)
{
    return fbrdfInfluenceWindow(squares.x, inverseRadiusSquared) * min(squares.y, 1e12);
}

// Twin: coneFactor, Light.h. wi: unit, towards the light.
float fbrdfConeFactor(vec4 cone, vec3 wi)
{
    float edge = clamp(cone.w - dot(cone.xyz, wi), 0.0, 1.0);
    return edge * edge;
}

// The unit direction to a light, given by its first vector and the last number of the second, and what fbrdfFalloff
// needs. 1e-30 is above the smallest normal float, so that the direction is finite at the light itself.
vec3 fbrdfToLight(vec4 position, float isLocated, vec3 point, out vec2 squares)
{
    vec3 toLight = position.xyz - isLocated * point;
    float square = dot(toLight, toLight), inverse = inversesqrt(max(square, 1e-30));
    squares = vec2(square, inverse * inverse);
    return toLight * inverse;
}

// Irradiance on a surface that faces the light (docs/method.md, Eq. 2), and the unit direction to the light.
vec3 fbrdfIrradiance(vec4 position, vec4 intensity, vec4 cone, vec3 point, out vec3 wi)
{
    vec2 squares;
    wi = fbrdfToLight(position, intensity.w, point, squares);
    return intensity.rgb * (fbrdfFalloff(squares, position.w) * fbrdfConeFactor(cone, wi));
}
// Turns exposed radiance into the value that is stored. Twins: Transfer.h.

// IEC 61966-2-1:1999; x in [0, 1].
vec3 fbrdfSrgbFromLinear(vec3 x)
{
    vec3 curve = 1.055 * pow(max(x, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055;
    return mix(curve, 12.92 * x, vec3(lessThanEqual(x, vec3(0.0031308))));
}

// Reinhard et al. 2002, "Photographic Tone Reproduction for Digital Images", Eq. 4, white at 4.
vec3 fbrdfToneMapped(vec3 radiance)
{
    vec3 x = clamp(radiance, 0.0, 4.0);  // white, also where a sum is infinite
    return min(vec3(1.0), x * (1.0 + x / 16.0) / (1.0 + x));
}

uniform int fbrdfLightCount;
uniform sampler2D fbrdfTable0;
uniform sampler2D fbrdfTable1;
uniform sampler2D fbrdfTable3;
uniform vec3 fbrdfKnots2[6];
uniform vec3 fbrdfScale0;
uniform vec3 fbrdfScale1;
uniform vec4 fbrdfLights[24];
void main()
{
    vec3 viewer = fbrdfToViewer();
    FbrdfShadingFrame frame = fbrdfShadingFrame(fbrdfNormal, fbrdfTangent);
    vec3 wo = fbrdfLocal(frame, viewer);
    float NoV = wo.z;
    vec2 theta_o = fbrdfZenith(wo);
    float theta_o3_1 = fbrdfAxisCoordinate(true, 0.5, theta_o.x, theta_o.y) * 0.833333333 + 0.0833333333;
    vec3 exponent0 = vec3(0.0);
    vec3 product0 = fbrdfScale0;
    vec3 exponent1 = vec3(0.0);
    vec3 product1 = fbrdfScale1;
    exponent1 += FBRDF_TEXTURE2(fbrdfTable0, (fbrdfDiscPosition(8.0, 0.5, 3.5, wo) + 0.5) * 0.125).rgb;
    vec3 sum0 = vec3(0.0);
    vec3 sum1 = vec3(0.0);
    for (int i = 0; i < fbrdfLightCount; ++i) {
        vec4 position = fbrdfLights[3 * i], intensity = fbrdfLights[3 * i + 1];
        vec2 squares;
        vec3 toLight = fbrdfToLight(position, intensity.w, fbrdfPosition, squares);
        vec3 wi = fbrdfLocal(frame, toLight);
        float NoL = wi.z;
        if (NoL > 0.0) {
            vec3 weight = intensity.rgb * (NoL * fbrdfFalloff(squares, position.w) * fbrdfConeFactor(fbrdfLights[3 * i + 2], toLight));
            vec3 both = wi + wo;
            vec2 size = fbrdfSizeOf(both);
            vec3 h = fbrdfHalfVector(wo, wi);
            vec2 theta_i = fbrdfZenith(wi);
            vec2 theta_d = fbrdfDifferenceAngle(wo, wi, size.x);
            {
                vec3 exponent = exponent0;
                vec3 product = weight;
                exponent += FBRDF_TEXTURE2(fbrdfTable3, vec2(fbrdfAxisCoordinate(true, 0.5, theta_i.x, theta_i.y) * 0.833333333 + 0.0833333333, theta_o3_1)).rgb;
                sum0 += product * exp2(exponent);
            }
            {
                vec3 exponent = exponent1;
                vec3 product = weight;
                exponent += FBRDF_TEXTURE2(fbrdfTable1, (fbrdfDiscPosition(8.0, 0.5, 3.5, h) + 0.5) * 0.125).rgb;
                exponent += FBRDF_TEXTURE2(fbrdfTable0, (fbrdfDiscPosition(8.0, 0.5, 3.5, wi) + 0.5) * 0.125).rgb;
                { float x = fbrdfAxisCoordinate(false, 0.5, theta_d.x, theta_d.y) * 5.0; int k = int(min(max(0.0, x), 4.0)); exponent += mix(fbrdfKnots2[k], fbrdfKnots2[k + 1], x - float(k)); }
                sum1 += product * exp2(exponent);
            }
        }
    }
    vec3 total = NoV > 0.0 ? product0 * sum0 + product1 * sum1 : vec3(0.0);
    fbrdfColour = vec4(total, 1.0);
}
