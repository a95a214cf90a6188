// InheritedState.h - the state that OpenSceneGraph will apply to what is culled now, known before
// anything is drawn: it follows osg::State's rules of OVERRIDE and PROTECTED.
#pragma once
#include <osg/StateSet>

#include <optional>
#include <vector>

namespace osgUtil {
class CullVisitor;
class StateGraph;
}  // namespace osgUtil

namespace osgFbrdf {

class InheritedState {
public:
    /// The state sets above where the visitor is, those of the visitor among them, must outlive
    /// this object.
    explicit InheritedState(osgUtil::CullVisitor& visitor);

    /// That of a drawable with its own state set, which may be null: the state sets of `graph` and
    /// above, up to `root`, which does not count.
    InheritedState(const osgUtil::StateGraph* graph, const osgUtil::StateGraph* root,
                   const osg::StateSet* own);

    /// Empty where no state set has the mode.
    std::optional<bool> mode(osg::StateAttribute::GLMode mode) const;
    /// Null where no state set has such an attribute.
    const osg::StateAttribute* attribute(osg::StateAttribute::Type type) const;

    /// No state set has anything in this texture unit or one after it.
    int textureUnits() const;
    /// The same as mode and attribute in a texture unit, unit >= 0.
    std::optional<bool> textureMode(int unit, osg::StateAttribute::GLMode mode) const;
    const osg::StateAttribute* textureAttribute(int unit, osg::StateAttribute::Type type) const;

private:
    std::vector<const osg::StateSet*> sets_;  ///< those nearer to the root come first
};

}  // namespace osgFbrdf
