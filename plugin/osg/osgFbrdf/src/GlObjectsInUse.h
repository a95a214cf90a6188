// GlObjectsInUse.h - what FactorizedBrdf::releaseGLObjects() must see to beside the objects that
// the effect owns: the surfaces of the views that drew it, and the arrays of the model that
// contexts still have bound. Thread-safe.
#pragma once
#include <osg/observer_ptr>

#include <OpenThreads/Mutex>

#include <map>
#include <vector>

namespace osg {
class State;
}

namespace osgFbrdf {

class Surfaces;

class GlObjectsInUse {
public:
    /// The effect draws to these surfaces, which may go away before it does.
    void use(Surfaces& surfaces);
    /// Releases the surfaces; state: of one context, null: of all.
    void release(osg::State* state);

    /// True from release() on until arraysForgotten() is called for the context. OSG 3.6 dispatches
    /// an array anew only when it is another one: after a release it would draw from buffers that
    /// are gone (OpenGL reads address 0 then).
    bool arraysReleased(unsigned int contextId) const;
    void arraysForgotten(unsigned int contextId);

private:
    mutable OpenThreads::Mutex mutex_;
    std::vector<osg::observer_ptr<Surfaces>> surfaces_;
    unsigned int releases_ = 0;                       ///< calls of release()
    std::map<unsigned int, unsigned int> forgotten_;  ///< releases that a context has heard of
};

}  // namespace osgFbrdf
