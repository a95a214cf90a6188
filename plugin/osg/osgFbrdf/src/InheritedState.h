// InheritedState.h - what OpenSceneGraph will apply below the state sets that a cull traversal is
// in: the same rules of OVERRIDE and PROTECTED as osg::State, asked before anything is drawn.
#pragma once
#include <osg/StateSet>

#include <optional>
#include <vector>

namespace osgUtil {
class CullVisitor;
}

namespace osgFbrdf {

class InheritedState {
public:
    /// State sets above where the visitor is, its own among them. They must outlive this.
    explicit InheritedState(osgUtil::CullVisitor& visitor);

    /// Empty where no state set says anything of the mode.
    std::optional<bool> mode(osg::StateAttribute::GLMode mode) const;
    /// Null where no state set has one.
    const osg::StateAttribute* attribute(osg::StateAttribute::Type type) const;

private:
    std::vector<const osg::StateSet*> sets_;  ///< from the root
};

}  // namespace osgFbrdf
