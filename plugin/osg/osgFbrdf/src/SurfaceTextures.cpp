#include "SurfaceTextures.h"

#include "EmbeddedShaders.h"
#include "PassState.h"

#include <algorithm>

namespace osgFbrdf {
namespace {

using fbrdf::Angle;
using fbrdf::Direction;

/// True for a factor of the directions to light and viewer, each by itself.
bool isDiffuse(const fbrdf::Factor& factor)
{
    if (const auto* angles = std::get_if<std::vector<Angle>>(&factor.argument))
        return std::all_of(angles->begin(), angles->end(), [](Angle angle) {
            return angle == Angle::theta_i || angle == Angle::theta_o;
        });
    const auto& direction = std::get<Direction>(factor.argument);
    return direction.kind == Direction::Kind::combination &&
           (direction.weight_wo == 0.0 || direction.weight_wi == 0.0);
}

std::vector<int> tintedTerms(const fbrdf::Form& form, bool all)
{
    std::vector<int> diffuse, every;
    for (int t = 0; t < static_cast<int>(form.terms.size()); ++t) {
        const auto& factors = form.terms[static_cast<size_t>(t)].factors;
        every.push_back(t);
        if (std::all_of(factors.begin(), factors.end(), isDiffuse)) diffuse.push_back(t);
    }
    return all || diffuse.empty() ? every : diffuse;
}

osg::ref_ptr<osg::Texture2D> texel(const osg::Vec3f& value)
{
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(1, 1, 1, GL_RGB, GL_FLOAT);
    // 2 x 0.5 - 1 must be 0, which it is in floats.
    image->setInternalTextureFormat(GL_RGB32F_ARB);
    std::copy(value.ptr(), value.ptr() + 3, reinterpret_cast<float*>(image->data()));
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    texture->setUnRefImageDataAfterApply(false);  // another context may come
    return texture;
}

}  // namespace

std::string keyOf(const ModelTextures& textures)
{
    return std::to_string(textures.tint) + '/' + std::to_string(textures.alpha) + '/' +
           std::to_string(textures.normal) + (textures.tintsAll ? "*" : "-");
}

void addSurface(fbrdf::SurfaceInputs& inputs, const ModelTextures& textures,
                const fbrdf::Form& form)
{
    inputs.normalMap = textures.normal >= 0;
    if (!textures.hasAlpha()) return;
    inputs.tintHook = std::string(textures.tint >= 0 ? "#define OSG_FBRDF_TINT\n" : "") +
                      (textures.alpha >= 0 ? "#define OSG_FBRDF_ALPHA\n" : "") +
                      std::string(fbrdf::osgFbrdfShader("tint.glsl"));
    if (textures.tint >= 0) inputs.tintedTerms = tintedTerms(form, textures.tintsAll);
}

PlainTextures::PlainTextures() : white_(texel({1.0f, 1.0f, 1.0f})), flat_(texel({0.5f, 0.5f, 1.0f}))
{
}

void PlainTextures::addTo(osg::StateSet& state, const ModelTextures& textures) const
{
    const auto add = [&state](int unit, osg::Texture2D* texture, const char* name) {
        if (unit < 0) return;
        state.setTextureAttribute(static_cast<unsigned int>(unit), texture);
        state.addUniform(new osg::Uniform(name, unit), kOurs);
    };
    add(textures.tint, white_, "osgFbrdfTint");
    add(textures.alpha, white_, "osgFbrdfAlpha");
    add(textures.normal, flat_, "fbrdfNormalMap");
}

}  // namespace osgFbrdf
