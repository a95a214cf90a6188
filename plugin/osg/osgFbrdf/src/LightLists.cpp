#include "LightLists.h"

#include "Vectors.h"

#include <fbrdf/plan/LightVectors.h>

#include <osg/Array>

#include <algorithm>
#include <cmath>

namespace osgFbrdf {
namespace {

osg::ref_ptr<osg::TextureBuffer> textureOf(osg::Array* array, GLint format)
{
    // An empty buffer has no storage, which a texture needs.
    if (array->getNumElements() == 0) array->resizeArray(1);
    osg::ref_ptr<osg::TextureBuffer> texture = new osg::TextureBuffer;
    texture->setInternalFormat(format);
    texture->setBufferData(array);
    return texture;
}

osg::ref_ptr<osg::IntArray> integers(const std::vector<int32_t>& values)
{
    return new osg::IntArray(values.begin(), values.end());
}

osg::ref_ptr<osg::Vec4Array> vectors(const std::vector<fbrdf::LightVectors>& lights)
{
    osg::ref_ptr<osg::Vec4Array> array = new osg::Vec4Array;
    array->reserve(lights.size() * fbrdf::kVectorsPerLight);
    for (const fbrdf::LightVectors& light : lights)
        for (const glm::vec4& v : light) array->push_back({v.x, v.y, v.z, v.w});
    return array;
}

osg::ref_ptr<osg::Vec2iArray> pairs(const std::vector<int32_t>& values)
{
    osg::ref_ptr<osg::Vec2iArray> array = new osg::Vec2iArray;
    array->reserve(values.size() / 2);
    for (size_t i = 0; i + 1 < values.size(); i += 2) array->push_back({values[i], values[i + 1]});
    return array;
}

/// The projection to the whole of the window up to the far corner of the viewport, as fragments
/// count their pixels from there.
osg::Matrixd toWindow(const osg::Matrixd& projection, const osg::Viewport& viewport)
{
    const double width = viewport.x() + viewport.width(), height = viewport.y() + viewport.height();
    return projection *
           osg::Matrixd::scale(viewport.width() / width, viewport.height() / height, 1.0) *
           osg::Matrixd::translate(viewport.x() / width, viewport.y() / height, 0.0);
}

/// Objects below different transforms find the way from the lights to the eye with other roundings.
bool isSame(const osg::Matrixd& a, const osg::Matrixd& b)
{
    for (int i = 0; i < 16; ++i) {
        const double x = a.ptr()[i], y = b.ptr()[i];
        if (std::abs(x - y) > 1e-12 * (1.0 + std::abs(x) + std::abs(y))) return false;
    }
    return true;
}

}  // namespace

const LightLists* LightListMaker::listsOf(const SceneLights& scene, const osg::Matrixd& toEye,
                                          const osg::Matrixd& projection,
                                          const osg::Viewport& viewport)
{
    if (scene.lights.size() + scene.sources.size() < kFewestListedLights) return nullptr;
    const osg::Vec4d corners(viewport.x(), viewport.y(), viewport.width(), viewport.height());
    const bool lightsStay = serial_ == scene.serial && isSame(toEye_, toEye);
    if (lightsStay && lists_ && scene.sources.empty() && attenuations_.empty() &&
        vectors_.size() == pointLights_ && projection_ == projection && viewport_ == corners)
        return visibleLists();
    if (!lightsStay) {
        serial_ = scene.serial;
        toEye_ = toEye;
        pointLights_ = scene.lights.size();
        vectors_.resize(pointLights_);
        const glm::dmat4 matrix = toGlm(toEye);
        for (size_t i = 0; i < pointLights_; ++i)
            vectors_[i] = fbrdf::lightVectors(scene.lights[i], matrix);
    }
    const auto attenuations = attenuations_;
    if (!addSources(scene, toEye)) return nullptr;
    const bool isNew = builder_.update(vectors_, toGlm(toWindow(projection, viewport)));
    if (isNew || !lists_ || viewport_ != corners || attenuations != attenuations_) {
        viewport_ = corners;
        makeLists(viewport);
    }
    projection_ = projection;
    return visibleLists();
}

const LightLists* LightListMaker::visibleLists() const
{
    return lists_->lights > 0 ? lists_.get() : nullptr;
}

/// False where there are more attenuations than the hook has.
bool LightListMaker::addSources(const SceneLights& scene, const osg::Matrixd& toEye)
{
    vectors_.resize(pointLights_);
    numbers_.assign(pointLights_, kNotAttenuated);
    attenuations_.clear();
    for (const PlacedOsgLight& source : scene.sources) {
        const ConvertedLight light = converted(source, toEye);
        vectors_.push_back(fbrdf::lightVectors(light.light, glm::dmat4(1.0)));
        numbers_.push_back(light.isAttenuated ? static_cast<int>(attenuations_.size())
                                              : kNotAttenuated);
        if (light.isAttenuated) attenuations_.push_back(light.attenuation);
    }
    return attenuations_.size() <= static_cast<size_t>(kMostAttenuations);
}

void LightListMaker::makeLists(const osg::Viewport& viewport)
{
    const fbrdf::LightClusters& clusters = builder_.clusters();
    std::vector<int32_t> numbers;
    for (const int32_t place : clusters.places)
        numbers.push_back(numbers_[static_cast<size_t>(place)]);
    lists_ = new LightLists;
    lists_->textures = {textureOf(vectors(clusters.lights), GL_RGBA32F_ARB),
                        textureOf(integers(clusters.indices), GL_R32I),
                        textureOf(pairs(clusters.lists), GL_RG32I),
                        textureOf(integers(numbers), GL_R32I)};
    lists_->attenuations = attenuations_;
    lists_->grid = clusters.grid;
    lists_->scale = {static_cast<float>(clusters.grid.columns / (viewport.x() + viewport.width())),
                     static_cast<float>(clusters.grid.rows / (viewport.y() + viewport.height())),
                     clusters.sliceScale, clusters.sliceBias};
    lists_->everywhere = clusters.everywhere;
    lists_->lights = static_cast<int>(clusters.lights.size());
    lists_->culled = static_cast<int>(vectors_.size() - clusters.lights.size());
    lists_->longest = clusters.longest;
    lists_->texels = std::max({clusters.lights.size() * fbrdf::kVectorsPerLight,
                               clusters.indices.size(), clusters.lists.size() / 2});
}

}  // namespace osgFbrdf
