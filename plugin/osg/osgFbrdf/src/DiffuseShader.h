// DiffuseShader.h - the diffuse fallback in contexts without fixed function: the same light by a
// program.
#pragma once
#include "OsgLights.h"

#include <osg/StateSet>
#include <osg/Vec3f>

#include <vector>

namespace osgFbrdf {

/// What fixed function is told of a surface and of the light that comes from everywhere.
struct DiffuseSurface {
    osg::Vec3f albedo, ambient;  ///< colours under diffuse and ambient light
    osg::Vec3f surrounding;      ///< ambient light beside that of the lights
};

/// One effect has one. Does not change.
class DiffuseShader : public osg::Referenced {
public:
    DiffuseShader();
    /// The program. bin: as setBin().
    osg::StateSet* state() const { return state_; }
    /// State of the pass that blends fog over it (FogPass.h), in the bin after that.
    osg::StateSet* fogState() const { return fog_; }
    /// What changes with the frame; the first kMostGlLights lights count.
    static osg::ref_ptr<osg::StateSet> frameState(const DiffuseSurface& surface,
                                                  const std::vector<PlacedOsgLight>& lights,
                                                  const osg::Matrixd& toEye);
    void resizeGLObjectBuffers(unsigned int maxSize);
    void releaseGLObjects(osg::State* state) const;

protected:
    ~DiffuseShader() override = default;

private:
    osg::ref_ptr<osg::StateSet> state_ = new osg::StateSet, fog_;
};

}  // namespace osgFbrdf
