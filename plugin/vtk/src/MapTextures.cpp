#include "MapTextures.h"

#include "EmbeddedShaders.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/plan/Plan.h>

#include <vtk_glew.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkShader.h>
#include <vtkShaderProgram.h>

#include <algorithm>

namespace fbrdf::vtk {
namespace {

constexpr int kGlsl = 150;  // VTK's shaders are written in it
/// Calls what is to be compiled.
constexpr const char* kProbe =
    "out vec4 colour;\nvoid main() { colour = vec4(vtkFbrdfShaded(vec3(0.0), vec3(0.0, 0.0, 1.0), "
    "vec4(0.0), true), 1.0); }\n";

int limitOf(vtkOpenGLRenderWindow& window, unsigned int name)
{
    int value = 0;
    window.GetState()->vtkglGetIntegerv(name, &value);
    return value;
}

bool samplesOnCpu(vtkOpenGLRenderWindow& window)
{
    const std::string& renderer = window.GetState()->GetRenderer();
    for (const char* known : {"llvmpipe", "softpipe", "SwiftShader"})
        if (renderer.find(known) != std::string::npos) return true;
    return false;
}

Capabilities capabilitiesOf(vtkOpenGLRenderWindow& window)
{
    Capabilities c;
    c.glMajor = 3;
    c.glMinor = 2;  // or VTK would not draw
    c.glsl = kGlsl;
    c.maxTextureUnits = limitOf(window, GL_MAX_TEXTURE_IMAGE_UNITS);
    c.maxTextureSize = limitOf(window, GL_MAX_TEXTURE_SIZE);
    c.max3dTextureSize = limitOf(window, GL_MAX_3D_TEXTURE_SIZE);
    c.maxUniformVectors = limitOf(window, GL_MAX_FRAGMENT_UNIFORM_COMPONENTS) / 4;
    c.floatTextures = true;
    c.softwareSampling = samplesOnCpu(window);
    return c;
}

struct GlFormat {
    unsigned int internal, type;
};

GlFormat formatOf(TexelType type)
{
    switch (type) {
        case TexelType::unorm16: return {GL_RGB16, GL_UNSIGNED_SHORT};
        case TexelType::half: return {GL_RGB16F, GL_HALF_FLOAT};
        case TexelType::float32: return {GL_RGBA32F, GL_FLOAT};
    }
    return {};
}

std::string whyTooLarge(const TextureImage& image, const std::string& name, const Capabilities& c)
{
    const auto [width, height, depth] = image.size;
    const int limit = depth > 1 ? c.max3dTextureSize : c.maxTextureSize;
    if (std::max({width, height, depth}) <= limit) return "";
    return "table '" + name + "': " +
           Found(std::to_string(width) + " x " + std::to_string(height) + " x " +
                 std::to_string(depth) + " texels")
               .expected("at most " + std::to_string(limit) + " on a side");
}

}  // namespace

std::string whyNotCompiled(const std::string& fragment)
{
    vtkNew<vtkShader> shader;
    shader->SetType(vtkShader::Fragment);
    shader->SetSource("#version 150\n" + fragment);
    const bool isCompiled = shader->Compile();
    shader->Cleanup();
    if (isCompiled) return "";
    const std::string error = shader->GetError();
    return Found("no GLSL (" + error.substr(0, error.find('\n')) + ")").expected("1.50");
}

std::string tooFew(const std::string& what, int needed, int limit)
{
    return what + ": " +
           Found(std::to_string(limit)).expected("at least " + std::to_string(needed));
}

MapTextures::MapTextures(const Material& material, bool precise, vtkOpenGLRenderWindow& window)
    : window_(&window), form_(material.form)
{
    const Capabilities c = capabilitiesOf(window);
    freeVectors_ = freeUniformVectors(form_, c);
    if (freeVectors_ < 0)
        refusal_ = tooFew("fragment uniform components", 4 * (c.maxUniformVectors - freeVectors_),
                          4 * c.maxUniformVectors);
    if (refusal_.empty()) makeMaps(material, precise, window);
    if (!refusal_.empty()) return;
    functions_ = written({});
    refusal_ = whyNotCompiled(functions_ + std::string(kProbe));
}

std::string MapTextures::written(const LobeShare& lobes) const
{
    return materialFunctions(form_, encodings_, kGlsl,
                             {std::string(vtkFbrdfShader("lights.glsl")), lobes}) +
           std::string(vtkFbrdfShader("shade.glsl"));
}

const std::string& MapTextures::functions(const LobeTable* lobes)
{
    if (!lobes) return functions_;
    if (lobeFunctions_.empty()) lobeFunctions_ = written(wholeShare(layoutOf(*lobes)));
    return lobeFunctions_;
}

const std::string& MapTextures::whyNoLobes(const LobeTable& lobes)
{
    if (!lobeFunctions_.empty() || !lobeRefusal_.empty()) return lobeRefusal_;
    const int needed = wholeShare(layoutOf(lobes)).vectors();
    lobeRefusal_ = needed > freeVectors_
                       ? tooFew("fragment uniform components", 4 * needed, 4 * freeVectors_)
                       : whyNotCompiled(functions(&lobes) + std::string(kProbe));
    return lobeRefusal_;
}

void MapTextures::makeMaps(const Material& material, bool precise, vtkOpenGLRenderWindow& window)
{
    const Capabilities c = capabilitiesOf(window);
    for (size_t k = 0; k < material.tables.size(); ++k) {
        const Table& table = material.tables[k];
        if (material.form.tables[k].uniform) {
            Map map;
            map.knots = uniformKnots(table);
            maps_.push_back(map);
            TableEncoding encoding;
            encoding.logarithmic = isLog(table.storage);
            encodings_.push_back(encoding);
            continue;
        }
        const TextureImage image = textureImage(table, c);
        refusal_ = whyTooLarge(image, table.name, c);
        if (!refusal_.empty()) return;
        maps_.push_back(mapOf(table, image, precise, window));
        encodings_.push_back(image.encoding);
        encodings_.back().precise = precise;
    }
}

MapTextures::Map MapTextures::mapOf(const Table& table, const TextureImage& image, bool precise,
                                    vtkOpenGLRenderWindow& window)
{
    vtkNew<vtkTextureObject> texture;
    texture->SetContext(&window);
    const GlFormat format = formatOf(image.type);
    texture->SetInternalFormat(format.internal);
    texture->SetDataType(format.type);
    texture->SetFormat(GL_RGB);
    const int filter = precise ? vtkTextureObject::Nearest : vtkTextureObject::Linear;
    texture->SetMinificationFilter(filter);
    texture->SetMagnificationFilter(filter);
    texture->SetWrapS(vtkTextureObject::ClampToEdge);
    texture->SetWrapT(vtkTextureObject::ClampToEdge);
    texture->SetWrapR(vtkTextureObject::ClampToEdge);
    texture->SetMaxLevel(0);
    // VTK takes what it only reads as if it wrote to it.
    void* const texels = image.type == TexelType::float32
                             ? static_cast<void*>(const_cast<float*>(image.floats.data()))
                             : static_cast<void*>(const_cast<uint16_t*>(image.words.data()));
    const auto width = static_cast<unsigned int>(image.size[0]),
               height = static_cast<unsigned int>(image.size[1]),
               depth = static_cast<unsigned int>(image.size[2]);
    if (dimensionCount(table.domain) == 3)
        texture->Create3DFromRaw(width, height, depth, 3, VTK_FLOAT, texels);
    else
        texture->Create2DFromRaw(width, height, 3, VTK_FLOAT, texels);
    textures_.emplace_back(texture.Get());
    return {texture.Get(), {}, image.lower, image.extent, image.encoding.ranged};
}

bool MapTextures::isAlive() const
{
    return window_ && std::all_of(textures_.begin(), textures_.end(),
                                  [](const auto& texture) { return texture->GetHandle() != 0; });
}

void MapTextures::setUniforms(vtkShaderProgram& program, const std::vector<Vec3f>& scales) const
{
    for (size_t i = 0; i < maps_.size(); ++i) {
        const Map& map = maps_[i];
        const std::string k = std::to_string(i);
        if (map.texture)
            program.SetUniformi(("fbrdfTable" + k).c_str(), map.texture->GetTextureUnit());
        if (map.ranged) {
            program.SetUniform3f(("fbrdfLower" + k).c_str(), &map.lower.x);
            program.SetUniform3f(("fbrdfExtent" + k).c_str(), &map.extent.x);
        }
        if (!map.knots.empty())
            program.SetUniform3fv(("fbrdfKnots" + k).c_str(), static_cast<int>(map.knots.size()),
                                  &map.knots.front().x);
    }
    for (size_t t = 0; t < scales.size(); ++t)
        program.SetUniform3f(("fbrdfScale" + std::to_string(t)).c_str(), &scales[t].x);
}

}  // namespace fbrdf::vtk
