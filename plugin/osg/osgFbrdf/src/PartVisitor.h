// PartVisitor.h - culls a model whose parts are drawn by effects of their own: one traversal for
// each number of a pass, in which every part goes under the state and into the bin of its own pass
// of that number. What is in no part of the table may keep its own state.
//
// A visitor of its own can do that without a change to the model, which other effects and threads
// may have too. It goes on where the visitor of the view is, and hands back what that one needs:
// leaves, near and far.
#pragma once
#include "PartNames.h"

#include <osgUtil/CullVisitor>

#include <vector>

namespace osgFbrdf {

class FactorizedBrdf;

/// Where what one pass draws is culled into: below the state of the pass, in its bin.
struct PartPass {
    osgUtil::StateGraph* graph = nullptr;
    osgUtil::RenderBin* bin = nullptr;
};
struct PartPasses {
    std::vector<PartPass> passes;
    /// What is blended is culled below it, into bins of its own; null: it is drawn as the rest.
    osgUtil::StateGraph* blended = nullptr;
};

class PartVisitor : public osgUtil::CullVisitor {
public:
    /// passes: those of each part of the table, in its order; they may repeat. rest: those of what
    /// is in no part; null: it keeps its own state. All must outlive this object.
    PartVisitor(osgUtil::CullVisitor& view, const PartNames& names,
                std::vector<const PartPasses*> passes, const PartPasses* rest);

    void cull(FactorizedBrdf& model);

    void apply(osg::Node& node) override { visit(node); }
    void apply(osg::Geode& node) override { visit(node); }
    void apply(osg::Drawable& drawable) override;
    void apply(osg::Billboard& node) override;
    void apply(osg::LightSource& node) override { visit(node); }
    void apply(osg::ClipNode& node) override { visit(node); }
    void apply(osg::TexGenNode& node) override { visit(node); }
    void apply(osg::Group& node) override { visit(node); }
    void apply(osg::Transform& node) override { visit(node); }
    void apply(osg::Projection& node) override { visit(node); }
    void apply(osg::Switch& node) override { visit(node); }
    void apply(osg::LOD& node) override { visit(node); }
    void apply(osg::ClearNode& node) override { visit(node); }
    void apply(osg::Camera& node) override;
    void apply(osg::OccluderNode& node) override { visit(node); }
    void apply(osg::OcclusionQueryNode& node) override { visit(node); }

protected:
    ~PartVisitor() override = default;

private:
    class Scope;
    template <class Node>
    void visit(Node& node);

    void goOnWhereIs(osgUtil::CullVisitor& view);
    const PartPasses* passesOf(int part) const;
    /// False where the part has no pass of this number.
    bool isDrawn() const;
    void enter(int part);
    /// Goes below the root, with the state of the model that is above the node.
    void goBelow(const PartPass& root, bool keepsBins);
    bool isBlended(const osg::Drawable& drawable) const;

    osgUtil::CullVisitor& view_;
    const PartNames& names_;
    std::vector<const PartPasses*> passes_;
    const PartPasses* rest_;
    const PartPasses own_;             ///< of what keeps its own state: one, where the view is
    unsigned int overridesAbove_ = 0;  ///< state sets above that put all into bins of theirs

    size_t pass_ = 0;                      ///< the number of the passes that are culled now
    PartPlace place_;                      ///< of the node that is visited now
    osgUtil::StateGraph* root_ = nullptr;  ///< below it is the state of the model alone
    bool elsewhere_ = false;               ///< within a camera that draws to another target
};

}  // namespace osgFbrdf
