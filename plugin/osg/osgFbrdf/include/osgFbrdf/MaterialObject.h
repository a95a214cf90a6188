// MaterialObject.h - a factored material as an object of OpenSceneGraph: shared by any number of
// effects, which then share textures and programs too.
#pragma once
#include <fbrdf/brdf/Material.h>

#include <osg/Object>
#include <osg/ref_ptr>
#include <osg/Vec3f>

#include <string>

namespace osgFbrdf {

class MaterialStates;

/// Once handed to an effect the object does not change, so any number of threads may cull and draw
/// with it; a file that is read again gives another object.
class MaterialObject : public osg::Object {
public:
    MaterialObject();  ///< no material: effects draw their fallback
    /// Throws fbrdf::Error(input) unless form, tables and scales agree.
    explicit MaterialObject(const fbrdf::Material& material, const std::string& fileName = "");
    MaterialObject(const MaterialObject& other, const osg::CopyOp& op = osg::CopyOp::SHALLOW_COPY);
    META_Object(osgFbrdf, MaterialObject)

    /// Takes the material of another, for readers of scenes, which make an object before they know
    /// what is in it. Precondition: nobody else has this one.
    void take(const MaterialObject& other);

    bool valid() const { return states_.valid(); }
    const fbrdf::Material& material() const { return material_; }
    /// Empty for a material that was made from memory.
    const std::string& fileName() const { return fileName_; }
    /// Linear RGB in [0, 1]: the colour of a diffuse surface that reflects as much.
    const osg::Vec3f& albedo() const { return albedo_; }

    /// State sets of the passes; null unless valid.
    MaterialStates* states() const { return states_.get(); }
    void resizeGLObjectBuffers(unsigned int maxSize) override;
    void releaseGLObjects(osg::State* state = nullptr) const override;

protected:
    ~MaterialObject() override;

private:
    fbrdf::Material material_;
    std::string fileName_;
    osg::Vec3f albedo_{0.5f, 0.5f, 0.5f};
    osg::ref_ptr<MaterialStates> states_;
};

}  // namespace osgFbrdf
