// EnvironmentLight.h - light from everywhere: a picture of all directions around a scene. It lights
// every FactorizedBrdf in the same scene, beside the lights, and nothing else.
//
// Pictures show latitude and longitude: the upper edge is at +z of the node, the middle column at
// +y, where OpenSceneGraph's viewers look first, and +x is to the right of it. Transforms above
// turn it; it is as far away as one can be, so where the node is does not matter. One environment
// lights a scene: the first that the view sees.
//
// Each context makes a cube map of it when it first draws, convolved with the lobes by which
// materials reflect (fbrdf/brdf/LobeTable.h); where OpenGL cannot, a thread does it more coarsely,
// and until then effects are drawn without. Rotation, intensity and number of lobes may change
// every frame and cost nothing. Lobes of a material file that has none are fitted by a thread when
// the material first meets an environment.
#pragma once
#include <osg/Group>
#include <osg/Image>
#include <osg/Vec3f>
#include <osgDB/Options>

#include <string>

namespace fbrdf {
struct Panorama;
}

namespace osgFbrdf {

class EnvironmentCube;

/// Change it in the update traversal.
class EnvironmentLight : public osg::Group {
public:
    EnvironmentLight();  ///< without a picture: lights nothing
    EnvironmentLight(const EnvironmentLight& other,
                     const osg::CopyOp& op = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgFbrdf, EnvironmentLight)

    /// "studio", "overcast" or "clear" (fbrdf/environment/Sky.h), or a file that a plugin of osgDB
    /// reads by its search paths. One that cannot be read gives a warning with the reason and
    /// lights nothing; the name is kept. Empty: no picture.
    bool setPictureFile(const std::string& file, const osgDB::Options* options = nullptr);
    const std::string& getPictureFile() const { return file_; }
    /// A picture from memory, twice as wide as high, of one to four channels: linear radiance (Rec.
    /// 709) in floats or halves, or sRGB in 8 or 16 bits. What is negative or no number counts as
    /// 0. The picture is copied; where it has no file name, scene files contain it. False, with a
    /// warning, for one that is none of these. Null: no picture.
    bool setPicture(const osg::Image* picture);
    /// The same from the runtime's form: row 0 is the upper edge (fbrdf/environment/Panorama.h).
    bool setPanorama(const fbrdf::Panorama& panorama);
    /// What lights; null unless valid.
    const fbrdf::Panorama* getPanorama() const;
    /// True where there is a picture that lights.
    bool valid() const { return cube_.valid(); }

    /// Radians about +z of the node, counter-clockwise seen from above.
    void setRotation(float radians) { rotation_ = radians; }
    float getRotation() const { return rotation_; }
    /// Multiplies the radiance of the picture; >= 0, or it lights nothing.
    void setIntensity(const osg::Vec3f& intensity) { intensity_ = intensity; }
    const osg::Vec3f& getIntensity() const { return intensity_; }
    /// 1 to 3: at most so many tilted lobes of a material beside the cosine, or 1, 3 or all bent
    /// ones; 0: as many as it has.
    void setLobes(int lobes) { lobes_ = lobes > 0 ? lobes : 0; }
    int getLobes() const { return lobes_; }
    /// Texels on a side of a face of the cube map: a power of two from 8 to 4096, which others are
    /// rounded up to. 512 takes 17 MB in each context; below that, and where a CPU samples
    /// textures, the narrowest lobes are as wide as texels ask for.
    void setFaceSize(int size);
    int getFaceSize() const { return faceSize_; }

    /// The cube map that contexts share with this node; null unless valid.
    EnvironmentCube* cube() const { return cube_.get(); }

    /// Makes transforms above DYNAMIC where osgUtil::Optimizer would flatten them.
    void traverse(osg::NodeVisitor& visitor) override;
    void resizeGLObjectBuffers(unsigned int maxSize) override;
    void releaseGLObjects(osg::State* state = nullptr) const override;

protected:
    ~EnvironmentLight() override;

private:
    std::string file_;
    osg::ref_ptr<EnvironmentCube> cube_;
    float rotation_ = 0.0f;
    osg::Vec3f intensity_{1.0f, 1.0f, 1.0f};
    int lobes_ = 0, faceSize_ = 512;
};

}  // namespace osgFbrdf
