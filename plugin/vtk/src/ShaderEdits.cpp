#include "ShaderEdits.h"

#include "EmbeddedShaders.h"

#include <vtkShaderProgram.h>

namespace fbrdf::vtk {
namespace {

// Markers of ours, which VTK leaves alone.
constexpr const char *kDeclare = "//fbrdf::Dec", *kColour = "//fbrdf::Color::Impl",
                     *kTangent = "//fbrdf::Tangent::Impl", *kLight = "//fbrdf::Light::Impl";

void replace(std::string& text, const std::string& from, const std::string& to)
{
    vtkShaderProgram::Substitute(text, from, to, false);
}

void insertAfter(std::string& text, const std::string& marker, const std::string& ours)
{
    replace(text, marker, marker + "\n" + ours + "\n");
}

bool has(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

/// Hands the tangents of the mesh to the fragment shader. A mesh without has the attribute 0.
void passTangents(const ShaderTexts& texts)
{
    const bool isDeclared = has(texts.vertex, "in vec3 tangentMC;");
    replace(texts.vertex, kDeclare,
            std::string(isDeclared ? "" : "in vec3 tangentMC;\n") +
                "uniform mat3 vtkFbrdfTangentMatrix;\nout vec3 vtkFbrdfTangentVSOutput;\n");
    replace(texts.vertex, kTangent,
            "  vtkFbrdfTangentVSOutput = vtkFbrdfTangentMatrix * tangentMC;\n");
    replace(texts.geometry, kDeclare,
            "in vec3 vtkFbrdfTangentVSOutput[];\nout vec3 vtkFbrdfTangentGSOutput;\n");
    replace(texts.geometry, kTangent, "  vtkFbrdfTangentGSOutput = vtkFbrdfTangentVSOutput[i];\n");
}

/// Statements that declare fbrdfTangent in main().
std::string tangentLines(const std::string& fragment, const ShaderWish& wish)
{
    if (!wish.isAnisotropic) return "  vec4 fbrdfTangent = vec4(0.0);\n";
    const std::string ofMesh = "vec4(vtkFbrdfTangentVSOutput, 1.0)";
    if (!has(fragment, "in vec2 tcoordVCVSOutput;"))
        return "  vec4 fbrdfTangent = " + ofMesh + ";\n";
    return "  vec4 fbrdfTangent = vtkFbrdfDerivedTangent(tcoordVCVSOutput, vertexVC.xyz, "
           "normalVCVSOutput);\n" +
           (wish.derivesTangents
                ? ""
                : "  if (dot(vtkFbrdfTangentVSOutput, vtkFbrdfTangentVSOutput) > 0.0) fbrdfTangent "
                  "= " +
                      ofMesh + ";\n");
}

/// Statements that write the colour of a fragment that knows its normal and place.
std::string litLines(const std::string& fragment, const ShaderWish& wish)
{
    std::string text = tangentLines(fragment, wish) +
                       "  vec3 fbrdfColour = vtkFbrdfShaded(vertexVC.xyz, normalVCVSOutput, "
                       "fbrdfTangent, " +
                       (wish.drawsFaces ? "true" : "false") + ");\n";
    if (has(fragment, "uniform vec3 edgeColor;"))
        text += "  fbrdfColour = mix(fbrdfColour, edgeColor, emix);\n";
    // Of vertices and selections VTK draws the ambient colour alone.
    return text +
           "  if (ambientIntensity == 1.0 && diffuseIntensity == 0.0) fbrdfColour = ambientColor;\n"
           "  gl_FragData[0] = vec4(fbrdfColour, opacity);\n";
}

}  // namespace

void takeMarkers(const ShaderTexts& texts, Look look)
{
    replace(texts.fragment, "//VTK::TCoord::Impl", "");
    if (look == Look::fallback) {
        insertAfter(texts.fragment, "//VTK::Color::Dec", kDeclare);
        return insertAfter(texts.fragment, "//VTK::Color::Impl", kColour);
    }
    replace(texts.fragment, "//VTK::Light::Dec", kDeclare);
    replace(texts.fragment, "//VTK::Light::Impl", kLight);
    insertAfter(texts.vertex, "//VTK::Normal::Dec", kDeclare);
    insertAfter(texts.vertex, "//VTK::Normal::Impl", kTangent);
    insertAfter(texts.geometry, "//VTK::Normal::Dec", kDeclare);
    insertAfter(texts.geometry, "//VTK::Normal::Impl", kTangent);
}

void writeMaterial(const ShaderTexts& texts, const ShaderWish& wish)
{
    std::string& fragment = texts.fragment;
    const bool isLit = has(fragment, "vec4 vertexVC =") && has(fragment, "vec3 normalVCVSOutput");
    std::string declarations, lines;
    if (isLit) {
        declarations = wish.functions;
        if (wish.isAnisotropic) {
            passTangents(texts);
            declarations +=
                std::string(vtkFbrdfShader("tangent.glsl")) + "in vec3 vtkFbrdfTangentVSOutput;\n";
        }
        lines = litLines(fragment, wish);
    } else {
        // Lines and points without normals, LightingOff: as VTK draws them.
        lines = wish.isDark ? "  gl_FragData[0] = vec4(vec3(0.0), opacity);\n"
                            : "  gl_FragData[0] = vec4(ambientColor + diffuseColor, opacity);\n";
    }
    replace(fragment, kDeclare, declarations);
    // Passes that come after ours find the marker that they look for.
    replace(fragment, kLight, lines + "  //VTK::Light::Impl\n");
}

void writeFallback(const ShaderTexts& texts)
{
    replace(texts.fragment, kDeclare, "uniform vec3 vtkFbrdfAlbedo;\n");
    replace(texts.fragment, kColour,
            std::string("  if (diffuseIntensity > 0.0) {\n    ambientColor = vec3(0.0);\n"
                        "    diffuseColor = vtkFbrdfAlbedo;\n") +
                (has(texts.fragment, "vec3 specularColor =") ? "    specularColor = vec3(0.0);\n"
                                                             : "") +
                "  }\n");
}

}  // namespace fbrdf::vtk
