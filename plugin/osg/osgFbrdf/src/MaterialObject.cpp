#include <osgFbrdf/MaterialObject.h>

#include "MaterialStates.h"

namespace osgFbrdf {

MaterialObject::MaterialObject() = default;
MaterialObject::~MaterialObject() = default;

MaterialObject::MaterialObject(const fbrdf::Material& material, const std::string& fileName)
    : material_(material), fileName_(fileName)
{
    fbrdf::validate(material_, fileName.empty() ? "material '" + material.name + "'" : fileName);
    setName(material.name);
    const fbrdf::Vec3f albedo = fbrdf::diffuseAlbedo(material_);
    albedo_.set(albedo.x, albedo.y, albedo.z);
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
