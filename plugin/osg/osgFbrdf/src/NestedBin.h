// NestedBin.h - what is culled while this lives goes into a bin of its own within the current one.
#pragma once
#include "PassState.h"

#include <osgUtil/CullVisitor>

namespace osgFbrdf {

// Outside every pass bin; after the opaque bin 0, before the transparent bin 10.
constexpr int kEffectBin = 1;

class NestedBin {
public:
    NestedBin(osgUtil::CullVisitor& visitor, int number) : visitor_(visitor)
    {
        setBin(*state_, number);
        visitor_.pushStateSet(state_);
    }
    ~NestedBin() { visitor_.popStateSet(); }
    NestedBin(const NestedBin&) = delete;
    NestedBin& operator=(const NestedBin&) = delete;
    void setDrawCallback(osgUtil::RenderBin::DrawCallback* callback)
    {
        visitor_.getCurrentRenderBin()->setDrawCallback(callback);
    }

private:
    osgUtil::CullVisitor& visitor_;
    osg::ref_ptr<osg::StateSet> state_ = new osg::StateSet;
};

}  // namespace osgFbrdf
