// EffectInternals.h - what the techniques of an effect keep with it and users of the effect do not
// see. Every member is safe to use from several threads at once.
#pragma once
#include "DiffuseShader.h"
#include "DrawLog.h"
#include "GlObjectsInUse.h"
#include "TechniqueChoice.h"

#include <atomic>

namespace osgFbrdf {

class EffectInternals : public osg::Referenced {
public:
    DrawLog log;
    GlObjectsInUse objects;
    const osg::ref_ptr<TechniqueChoice> choice = new TechniqueChoice;
    const osg::ref_ptr<DiffuseShader> diffuse = new DiffuseShader;
    std::atomic<bool> partsAreKnown{false};  ///< the log has the names in the table without a part
    /// The texture unit of a shadow map that was drawn from where the last frame had no light; -1:
    /// none.
    std::atomic<int> strayShadowMap{-1};

protected:
    ~EffectInternals() override = default;
};

}  // namespace osgFbrdf
