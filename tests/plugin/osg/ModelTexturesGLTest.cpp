// Textures of a model under an effect: colours, normals and alpha.
#include "EffectTest.h"
#include "EnvironmentTest.h"
#include "PartsTest.h"

#include "support/gl/CompareImages.h"
#include "support/gl/EnvironmentScenes.h"

#include <fbrdf/base/Srgb.h>

#include <osg/AlphaFunc>
#include <osg/BlendFunc>
#include <osg/Fog>
#include <osg/Texture2D>

namespace fbrdf::test {
namespace {

using osgFbrdf::FactorizedBrdf;
using osgFbrdf::ModelTextures;

constexpr double kSame = 1e-5;
constexpr int kTintUnit = 0, kAlphaUnit = 5, kNormalUnit = 1;

/// A texture of width texels beside each other, of RGBA in 8 bits.
osg::ref_ptr<osg::Texture2D> textureOf(const std::vector<std::array<unsigned char, 4>>& texels)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(static_cast<int>(texels.size()), 1, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    std::copy(texels.front().data(), texels.front().data() + 4 * texels.size(), image->data());
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    texture->setResizeNonPowerOfTwoHint(false);
    return texture;
}

/// The square [-1, 1]^2 at z, with texture coordinates in [0, 1], normals and tangents.
osg::ref_ptr<osg::Geometry> square(float z, const Vec3f& normal = {0.0f, 0.0f, 1.0f})
{
    gl::MeshData mesh;
    mesh.positions = {{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}};
    mesh.normals.assign(4, normal);
    mesh.tangents.assign(4, {1.0f, 0.0f, 0.0f});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    const auto geometry = osgMesh(mesh);
    const osg::ref_ptr<osg::Vec2Array> coordinates = new osg::Vec2Array;
    for (const Vec3f& p : mesh.positions)
        coordinates->push_back({0.5f + 0.5f * p.x, 0.5f + 0.5f * p.y});
    geometry->setTexCoordArray(0, coordinates, osg::Array::BIND_PER_VERTEX);
    return geometry;
}

osg::ref_ptr<osg::Geometry> textured(osg::Geometry* geometry, int unit, osg::Texture2D* texture)
{
    geometry->getOrCreateStateSet()->setTextureAttributeAndModes(static_cast<unsigned int>(unit),
                                                                 texture);
    return geometry;
}

class Textured : public EffectTest {
protected:
    void SetUp() override
    {
        EffectTest::SetUp();
        lights_->addChild(osgLights(testLights(9)));
    }
    osg::ref_ptr<FactorizedBrdf> effectOver(osg::Node* model, const ModelTextures& textures,
                                            const Material& material = testMaterials()[0])
    {
        const auto effect = EffectTest::effectOver(model, material);
        effect->setModelTextures(textures);
        return effect;
    }
    std::vector<float> picture(osg::Node* node) { return pictureOf(node, lights_); }

    osg::ref_ptr<osg::Group> lights_ = new osg::Group;
};

const std::array<unsigned char, 4> kCodes{188, 64, 5, 255};

Vec3f linearOf(const std::array<unsigned char, 4>& codes)
{
    const auto value = [](unsigned char code) {
        return linearFromSrgb(static_cast<float>(code) / 255.0f);
    };
    return {value(codes[0]), value(codes[1]), value(codes[2])};
}

std::vector<float> times(std::vector<float> image, const Vec3f& factor)
{
    for (size_t i = 0; i < image.size(); ++i)
        if (i % 4 < 3) image[i] *= factor[static_cast<int>(i % 4)];
    return image;
}

TEST_F(Textured, ColoursMultiplyReflectanceInLinearLight)
{
    lights_->addChild(uprightFor(osgEnvironment(testPanorama(16))));
    const Material material =
        withLobes(testMaterials()[0], testLobes(LobeAxes::tilted, 2));  // one term
    const auto plain = effectOver(square(0.0f), {}, material),
               tinted = effectOver(textured(square(0.0f), kTintUnit, textureOf({kCodes})),
                                   {kTintUnit}, material);
    for (const bool isFloat : {true, false})
        for (int technique = 0; technique < kTechniqueCount; ++technique) {
            for (const auto& effect : {plain, tinted}) {
                effect->setFloatTarget(isFloat);
                effect->selectTechnique(technique);
            }
            const auto d = compareImages(picture(tinted), times(picture(plain), linearOf(kCodes)));
            EXPECT_LT(d.maxRelative, kSame) << technique << ", " << isFloat << ": " << describe(d);
            EXPECT_EQ(tinted->lastReport().whyNoEnvironment, "");
        }
    // What has no texture is drawn as without.
    const auto bare = effectOver(square(0.0f), {kTintUnit, kAlphaUnit, kNormalUnit}, material);
    plain->selectTechnique(0);
    plain->setFloatTarget(true);
    const auto d = compareImages(picture(bare), picture(plain));
    EXPECT_LT(d.maxRelative, kSame) << describe(d);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

// io + pqp: highlights keep their colour, unless all is tinted.
TEST_F(Textured, ColoursMultiplyDiffuseTermsAloneWhereThereAreSome)
{
    const Material both = noiseMaterial(sumOf(formIo(), formPqp(8, 0.5)), Storage::half);
    Material diffuse = both, other = both;
    diffuse.scales[1] = other.scales[0] = Vec3f(0.0f);
    const auto of = [&](const Material& material) {
        return picture(effectOver(square(0.0f), {}, material));
    };
    const auto diffusePart = of(diffuse), otherPart = of(other);
    for (const bool all : {false, true})
        for (int technique = 0; technique < kTechniqueCount; ++technique) {
            const auto effect = effectOver(textured(square(0.0f), kTintUnit, textureOf({kCodes})),
                                           {kTintUnit, -1, -1, all}, both);
            effect->selectTechnique(technique);
            auto expected = times(diffusePart, linearOf(kCodes));
            const auto rest = all ? times(otherPart, linearOf(kCodes)) : otherPart;
            for (size_t i = 0; i < expected.size(); ++i)
                if (i % 4 < 3) expected[i] += rest[i];
            const auto d = compareImages(picture(effect), expected);
            EXPECT_LT(d.maxRelative, 1e-4) << technique << ", " << all << ": " << describe(d);
        }
}

TEST_F(Textured, NormalMapsTurnTheFrame)
{
    const std::array<unsigned char, 4> texel{166, 105, 230, 255};
    const auto component = [&](size_t c) {
        return 2.0f * static_cast<float>(texel[c]) / 255.0f - 1.0f;
    };
    const Vec3f normal = glm::normalize(Vec3f(component(0), component(1), component(2)));
    const auto mapped = effectOver(textured(square(0.0f), kNormalUnit, textureOf({texel})),
                                   {-1, -1, kNormalUnit}),
               turned = effectOver(square(0.0f, normal), {}), plain = effectOver(square(0.0f), {});
    for (const int technique : {0, 2}) {
        mapped->selectTechnique(technique);
        turned->selectTechnique(technique);
        const auto found = picture(mapped), expected = picture(turned);
        const auto d = compareImages(found, expected);
        EXPECT_LT(d.maxRelative, 1e-3) << describe(d);
        EXPECT_GT(compareImages(found, picture(plain)).maxRelative, 0.1);
    }
}

TEST_F(Textured, HolesOfTheAlphaTestStayHolesInAllPasses)
{
    const std::array<unsigned char, 4> solid{255, 255, 255, 255}, hole{255, 255, 255, 0};
    const auto leaf = textured(square(0.5f), kTintUnit, textureOf({hole, solid}));
    leaf->getOrCreateStateSet()->setAttributeAndModes(
        new osg::AlphaFunc(osg::AlphaFunc::GREATER, 0.5f));
    osg::ref_ptr<osg::Group> withLeaf = new osg::Group;
    withLeaf->addChild(leaf);
    withLeaf->addChild(square(-1.0f));
    osg::ref_ptr<osg::Group> withSolid = new osg::Group;
    withSolid->addChild(square(0.5f));
    withSolid->addChild(square(-1.0f));
    for (const bool isFloat : {true, false})
        for (int technique = 0; technique < kTechniqueCount; ++technique) {
            const auto draw = [&](osg::Node* model, const ModelTextures& textures) {
                const auto effect = effectOver(model, textures);
                effect->setFloatTarget(isFloat);
                effect->selectTechnique(technique);
                return picture(effect);
            };
            const auto found = draw(withLeaf, {kTintUnit}), behind = draw(square(-1.0f), {}),
                       front = draw(withSolid, {});
            for (size_t i = 0; i < found.size(); i += 4) {
                const bool isHole = i / 4 % kSize < kSize / 2;
                const float expected = isHole ? behind[i] : front[i];
                ASSERT_NEAR(found[i], expected, 1e-5f * (1.0f + expected))
                    << i / 4 % kSize << ", technique " << technique << ", " << isFloat;
            }
            EXPECT_GT(compareImages(front, behind).maxRelative, 0.01);
        }
}

/// A square that is blended in front of what it is with.
osg::ref_ptr<osg::Geometry> pane(float z, unsigned char alpha)
{
    const auto geometry = textured(square(z), kTintUnit, textureOf({{255, 255, 255, alpha}}));
    auto* state = geometry->getOrCreateStateSet();
    state->setAttributeAndModes(new osg::BlendFunc);
    state->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
    return geometry;
}

TEST_F(Textured, WhatIsBlendedIsBlendedInOnePassAndInItsOrder)
{
    const float alpha = 64.0f / 255.0f;
    for (const bool isFloat : {true, false})
        for (int technique = 0; technique < kTechniqueCount; ++technique) {
            const auto draw = [&](const std::vector<osg::ref_ptr<osg::Geometry>>& drawables) {
                osg::ref_ptr<osg::Group> model = new osg::Group;
                for (const auto& drawable : drawables) model->addChild(drawable);
                const auto effect = effectOver(model, {kTintUnit});
                effect->setFloatTarget(isFloat);
                effect->selectTechnique(technique);
                const auto found = picture(effect);
                EXPECT_EQ(effect->lastReport().whyOpaque, "");
                return found;
            };
            const auto near = draw({square(0.5f)}), middle = draw({square(0.0f)}),
                       far = draw({square(-1.0f)});
            // In the graph the nearest comes first.
            const auto found = draw({pane(0.5f, 64), pane(0.0f, 64), square(-1.0f)});
            const auto over = [&](const std::vector<float>& pane, size_t i, float behind) {
                return pane[i + 3] > 0.0f ? alpha * pane[i] + (1.0f - alpha) * behind : behind;
            };
            for (size_t i = 0; i < found.size(); i += 4) {
                const float expected = over(near, i, over(middle, i, far[i]));
                ASSERT_NEAR(found[i], expected, 1e-4f * (1.0f + expected))
                    << "technique " << technique << ", " << isFloat;
            }
        }
}

TEST_F(Textured, AlphaMapsAndTheAlphaOfMaterialsMultiply)
{
    const auto glass = square(0.5f);
    const osg::ref_ptr<osg::Material> half = new osg::Material;
    half->setDiffuse(osg::Material::FRONT_AND_BACK, {1.0f, 1.0f, 1.0f, 0.5f});
    auto* state = textured(glass, kAlphaUnit, textureOf({{128, 0, 0, 255}}))->getStateSet();
    state->setAttribute(half);
    state->setAttributeAndModes(new osg::BlendFunc);
    state->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
    const auto front = picture(effectOver(square(0.5f), {})),
               found = picture(effectOver(glass, {-1, kAlphaUnit}));
    const float alpha = 0.5f * 128.0f / 255.0f;
    for (size_t i = 0; i < found.size(); i += 4)
        ASSERT_NEAR(found[i], alpha * front[i], 1e-4f * (1.0f + front[i]));
    EXPECT_GT(meanOf(front, 0), 0.01);
}

// Parts have textures too, each by the tint of its own material.
TEST_F(Textured, PartsAreTintedAndBlended)
{
    osg::ref_ptr<osg::Group> model = new osg::Group;
    const auto front = pane(0.5f, 64), back = square(-1.0f);
    front->setName("glass");
    model->addChild(front);
    model->addChild(back);
    const auto expected = picture(effectOver(model, {kTintUnit}));
    const auto effect = effectOver(model, {kTintUnit});
    effect->setPartMaterial("glass", new osgFbrdf::MaterialObject(testMaterials()[0]));
    const auto d = compareImages(picture(effect), expected);
    EXPECT_LT(d.maxRelative, kSame) << describe(d);
}

}  // namespace
}  // namespace fbrdf::test
