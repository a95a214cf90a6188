#include <osgFbrdf/MaterialObject.h>

#include "MaterialStates.h"

#include <algorithm>
#include <cmath>

namespace osgFbrdf {
namespace {

// Directions of light for the albedo: a grid even in cos^2 (so that each weighs the same under the
// cosine) and in azimuth. 16 x 16 is within a few percent of the integral for all but mirrors.
constexpr int kGrid = 16;

osg::Vec3f albedoOf(const fbrdf::Material& material)
{
    // Seen at 45 degrees, between the brightest and the darkest view.
    const fbrdf::Vec3f wo(std::sqrt(0.5f), 0.0f, std::sqrt(0.5f));
    fbrdf::Vec3f sum(0.0f);
    for (int i = 0; i < kGrid; ++i)
        for (int j = 0; j < kGrid; ++j) {
            const float square = (static_cast<float>(i) + 0.5f) / kGrid;
            const float phi =
                2.0f * static_cast<float>(fbrdf::kPi) * (static_cast<float>(j) + 0.5f) / kGrid;
            const float sine = std::sqrt(1.0f - square);
            sum += fbrdf::evaluate<float>(
                material, wo, {sine * std::cos(phi), sine * std::sin(phi), std::sqrt(square)});
        }
    osg::Vec3f albedo;
    for (int c = 0; c < 3; ++c) {
        const float value = sum[c] * static_cast<float>(fbrdf::kPi) / (kGrid * kGrid);
        albedo[c] = std::clamp(value, 0.0f, 1.0f);
    }
    return albedo;
}

}  // namespace

MaterialObject::MaterialObject() = default;
MaterialObject::~MaterialObject() = default;

MaterialObject::MaterialObject(const fbrdf::Material& material, const std::string& fileName)
    : material_(material), fileName_(fileName)
{
    fbrdf::validate(material_, fileName.empty() ? "material '" + material.name + "'" : fileName);
    setName(material.name);
    albedo_ = albedoOf(material_);
    states_ = new MaterialStates(material_);
}

MaterialObject::MaterialObject(const MaterialObject& other, const osg::CopyOp& op)
    : osg::Object(other, op),
      material_(other.material_),
      fileName_(other.fileName_),
      albedo_(other.albedo_),
      states_(other.states_)
{
}

void MaterialObject::take(const MaterialObject& other)
{
    material_ = other.material_;
    fileName_ = other.fileName_;
    albedo_ = other.albedo_;
    states_ = other.states_;
}

void MaterialObject::resizeGLObjectBuffers(unsigned int maxSize)
{
    if (states_) states_->resizeGLObjectBuffers(maxSize);
}

void MaterialObject::releaseGLObjects(osg::State* state) const
{
    if (states_) states_->releaseGLObjects(state);
}

}  // namespace osgFbrdf
