#include "PartVisitor.h"

#include "InheritedState.h"

#include <osgFbrdf/FactorizedBrdf.h>

#include <osg/Billboard>
#include <osg/Camera>
#include <osg/ClearNode>
#include <osg/ClipNode>
#include <osg/LightSource>
#include <osg/LOD>
#include <osg/OccluderNode>
#include <osg/OcclusionQueryNode>
#include <osg/Projection>
#include <osg/Switch>
#include <osg/TexGenNode>
#include <osg/Transform>

#include <algorithm>
#include <utility>

namespace osgFbrdf {
namespace {

/// The state sets above that let nothing below choose its own bin.
unsigned int overridingBins(const osgUtil::StateGraph* graph)
{
    unsigned int count = 0;
    for (; graph; graph = graph->_parent)
        if (graph->getStateSet() &&
            (graph->getStateSet()->getRenderBinMode() & osg::StateSet::OVERRIDE_RENDERBIN_DETAILS))
            ++count;
    return count;
}

size_t mostPasses(const std::vector<const PartPasses*>& parts)
{
    size_t most = 0;
    for (const PartPasses* passes : parts) most = std::max(most, passes->passes.size());
    return most;
}

}  // namespace

/// Within it the visitor is in a part; afterwards it is where it was.
class PartVisitor::Scope {
public:
    Scope(PartVisitor& visitor, const PartPlace& place)
        : visitor_(visitor),
          place_(visitor.place_),
          root_(visitor.root_),
          graph_(visitor._currentStateGraph),
          bin_(visitor._currentRenderBin),
          binsBelow_(visitor._renderBinStack.size()),
          overrides_(visitor._numberOfEncloseOverrideRenderBinDetails)
    {
        visitor_.place_ = place;
        if (place.part != place_.part) visitor_.enter(place.part);
    }
    ~Scope()
    {
        visitor_.place_ = place_;
        visitor_.root_ = root_;
        visitor_._currentStateGraph = graph_;
        visitor_._currentRenderBin = bin_;
        visitor_._renderBinStack.resize(binsBelow_);
        visitor_._numberOfEncloseOverrideRenderBinDetails = overrides_;
    }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

private:
    PartVisitor& visitor_;
    const PartPlace place_;
    osgUtil::StateGraph *const root_, *const graph_;
    osgUtil::RenderBin* const bin_;
    const size_t binsBelow_;
    const unsigned int overrides_;
};

PartVisitor::PartVisitor(osgUtil::CullVisitor& view, const PartNames& names,
                         std::vector<const PartPasses*> passes, const PartPasses* rest)
    : osgUtil::CullVisitor(view),
      view_(view),
      names_(names),
      passes_(std::move(passes)),
      rest_(rest),
      own_{{{view.getCurrentStateGraph(), view.getCurrentRenderBin()}}},
      overridesAbove_(overridingBins(view.getCurrentStateGraph()))
{
    goOnWhereIs(view);
}

// The constructors of OSG that copy visitors leave all of this out.
void PartVisitor::goOnWhereIs(osgUtil::CullVisitor& view)
{
    setTraversalNumber(view.getTraversalNumber());
    setFrameStamp(const_cast<osg::FrameStamp*>(view.getFrameStamp()));
    setDatabaseRequestHandler(view.getDatabaseRequestHandler());
    setImageRequestHandler(view.getImageRequestHandler());
    setValueMap(view.getValueMap());
    setUserDataContainer(view.getUserDataContainer());  // the ViewState is in it
    getNodePath() = view.getNodePath();
    setIdentifier(view.getIdentifier());
    setRenderInfo(view.getRenderInfo());
    setRenderStage(view.getRenderStage());
    setOccluderList(view.getOccluderList());
    reset();
    if (view.getViewport()) pushViewport(view.getViewport());
    pushProjectionMatrix(view.getProjectionMatrix());
    pushReferenceViewPoint(view.getReferenceViewPoint());
    pushModelViewMatrix(view.getModelViewMatrix(), osg::Transform::RELATIVE_RF);
}

void PartVisitor::cull(FactorizedBrdf& model)
{
    const size_t passes = std::max(mostPasses(passes_), passesOf(kRest)->passes.size());
    for (pass_ = 0; pass_ < passes; ++pass_) {
        root_ = _currentStateGraph = own_.passes.front().graph;
        enter(kRest);
        model.inherited_traverse(*this);
    }
    computeNearPlane();
    view_.setCalculatedNearPlane(
        std::min(view_.getCalculatedNearPlane(), getCalculatedNearPlane()));
    view_.setCalculatedFarPlane(std::max(view_.getCalculatedFarPlane(), getCalculatedFarPlane()));
    // They are the graph's now. A visitor resets the leaves that it still has when it ends.
    _reuseRenderLeafList.clear();
    _currentReuseRenderLeafIndex = 0;
}

const PartPasses* PartVisitor::passesOf(int part) const
{
    if (part != kRest) return passes_[static_cast<size_t>(part)];
    return rest_ ? rest_ : &own_;
}

bool PartVisitor::isDrawn() const
{
    return pass_ < passesOf(place_.part)->passes.size();
}

void PartVisitor::enter(int part)
{
    const PartPasses& passes = *passesOf(part);
    if (pass_ < passes.passes.size()) goBelow(passes.passes[pass_], &passes == &own_);
}

void PartVisitor::goBelow(const PartPass& root, bool keepsBins)
{
    std::vector<const osg::StateSet*> above;
    for (auto* graph = _currentStateGraph; graph != root_; graph = graph->_parent)
        above.push_back(graph->getStateSet());
    root_ = _currentStateGraph = root.graph;
    _currentRenderBin = root.bin;
    _numberOfEncloseOverrideRenderBinDetails = overridesAbove_ + (keepsBins ? 0 : 1);
    for (auto state = above.rbegin(); state != above.rend(); ++state) pushStateSet(*state);
}

bool PartVisitor::isBlended(const osg::Drawable& drawable) const
{
    return InheritedState(_currentStateGraph, root_, drawable.getStateSet())
        .mode(GL_BLEND)
        .value_or(false);
}

template <class Node>
void PartVisitor::visit(Node& node)
{
    const PartPlace place = elsewhere_ ? place_ : names_.inside(node, place_);
    if (place.part == place_.part) {
        const PartPlace above = std::exchange(place_, place);
        CullVisitor::apply(node);
        place_ = above;
        return;
    }
    const Scope scope(*this, place);
    CullVisitor::apply(node);
}

void PartVisitor::apply(osg::Drawable& drawable)
{
    const Scope scope(*this, elsewhere_ ? place_ : names_.inside(drawable, place_));
    osgUtil::StateGraph* blended = passesOf(place_.part)->blended;
    if (blended && isBlended(drawable)) {
        if (pass_ > 0) return;
        const Scope inBlended(*this, place_);
        goBelow({blended, own_.passes.front().bin}, true);
        CullVisitor::apply(drawable);
    } else if (isDrawn()) {
        CullVisitor::apply(drawable);
    }
}

void PartVisitor::apply(osg::Billboard& node)
{
    const Scope scope(*this, elsewhere_ ? place_ : names_.inside(node, place_));
    if (isDrawn()) CullVisitor::apply(node);  // with its drawables, whatever their names
}

// What draws to another target has none of the bins here, and is drawn once.
void PartVisitor::apply(osg::Camera& node)
{
    if (elsewhere_ || node.getRenderOrder() == osg::Camera::NESTED_RENDER) return visit(node);
    if (pass_ > 0) return;
    const PartPasses* rest = std::exchange(rest_, nullptr);
    {
        const Scope scope(*this, {});
        enter(kRest);
        elsewhere_ = true;
        CullVisitor::apply(node);
        elsewhere_ = false;
    }
    rest_ = rest;
}

}  // namespace osgFbrdf
