// ForgetArrays.h - makes OSG dispatch the arrays of a model anew (GlObjectsInUse::arraysReleased).
#pragma once
#include "EffectInternals.h"

#include <osgUtil/RenderBin>

namespace osgFbrdf {

class ForgetArrays : public osgUtil::RenderBin::DrawCallback {
public:
    explicit ForgetArrays(EffectInternals& internals) : internals_(&internals) {}
    void drawImplementation(osgUtil::RenderBin* bin, osg::RenderInfo& info,
                            osgUtil::RenderLeaf*& previous) override
    {
        osg::State& state = *info.getState();
        state.disableAllVertexArrays();
        // State's own function of this name disables one.
        state.getCurrentVertexArrayState()->disableVertexAttribArrayAboveAndIncluding(state, 0);
        state.unbindVertexBufferObject();
        state.unbindElementBufferObject();
        internals_->objects.arraysForgotten(state.getContextID());
        bin->drawImplementation(info, previous);
    }

private:
    osg::ref_ptr<EffectInternals> internals_;
};

}  // namespace osgFbrdf
