#include "PlainParts.h"

#include "PartNames.h"

#include <osgFbrdf/FactorizedBrdf.h>

#include <osg/Drawable>
#include <osg/NodeVisitor>
#include <osg/ValueObject>

#include <algorithm>
#include <utility>

namespace osgFbrdf {
namespace {

/// Key of the user value of a node that has another state set than in the scene; that of the scene
/// is the user object before it.
constexpr const char* kPainted = "osgFbrdf painted part";

void paint(osg::Node& node, osg::StateAttribute& material)
{
    const osg::ref_ptr<osg::StateSet> own = node.getStateSet();
    osg::ref_ptr<osg::UserDataContainer> container =
        node.getUserDataContainer()
            ? osg::clone(node.getUserDataContainer(), osg::CopyOp::DEEP_COPY_USERDATA)
            : new osg::DefaultUserDataContainer;
    if (own) container->addUserObject(own);
    node.setUserDataContainer(container);
    node.setUserValue(kPainted, true);
    node.setStateSet(own ? osg::clone(own.get()) : new osg::StateSet);
    node.getStateSet()->setAttributeAndModes(&material, osg::StateAttribute::ON |
                                                            osg::StateAttribute::OVERRIDE |
                                                            osg::StateAttribute::PROTECTED);
}

class PartPainter : public osg::NodeVisitor {
public:
    PartPainter(const FactorizedBrdf& effect, bool ambient)
        : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN), names_(effect.getParts())
    {
        setNodeMaskOverride(~0u);
        for (const ModelPart& part : effect.getParts())
            materials_.push_back(plainMaterial(*part.effect, ambient));
        if (drawsRest(effect)) rest_ = plainMaterial(effect, ambient);
    }
    void apply(osg::Node& node) override
    {
        const PartPlace above = std::exchange(place_, names_.inside(node, place_));
        if (place_.part != above.part) paint(ownCopyOf(node), materialOf(node));
        traverse(node);
        place_ = above;
    }

private:
    /// The node, or a copy in its place where it is a drawable, which the scene may have too.
    osg::Node& ownCopyOf(osg::Node& node)
    {
        if (!node.asDrawable()) return node;
        const osg::ref_ptr<osg::Drawable> copy = osg::clone(node.asDrawable());
        osg::Group* parent = getNodePath()[getNodePath().size() - 2]->asGroup();
        parent->replaceChild(&node, copy);
        return *copy;
    }
    osg::StateAttribute& materialOf(osg::Node& node)
    {
        if (place_.part != kRest) return *materials_[static_cast<size_t>(place_.part)];
        // A part above ends at an osg::Material of the model.
        return rest_ ? *rest_ : *node.getStateSet()->getAttribute(osg::StateAttribute::MATERIAL);
    }

    const PartNames names_;
    std::vector<osg::ref_ptr<osg::Material>> materials_;  ///< of the parts
    osg::ref_ptr<osg::Material> rest_;
    PartPlace place_;
};

}  // namespace

osg::ref_ptr<osg::Material> plainMaterial(const FactorizedBrdf& effect, bool ambient)
{
    osg::Vec3f albedo(0.5f, 0.5f, 0.5f);
    if (effect.getMaterial()) albedo = effect.getMaterial()->albedo();
    albedo *= effect.getExposure();
    for (int c = 0; c < 3; ++c) albedo[c] = std::min(albedo[c], 1.0f);
    const osg::ref_ptr<osg::Material> material = new osg::Material;
    material->setColorMode(osg::Material::OFF);
    material->setDiffuse(osg::Material::FRONT_AND_BACK, osg::Vec4f(albedo, 1.0f));
    if (ambient) material->setAmbient(osg::Material::FRONT_AND_BACK, osg::Vec4f(albedo, 1.0f));
    return material;
}

void paintParts(FactorizedBrdf& effect, bool ambient)
{
    PartPainter painter(effect, ambient);
    // A child may be replaced meanwhile.
    for (unsigned int i = 0; i < effect.getNumChildren(); ++i) {
        painter.pushOntoNodePath(&effect);
        effect.getChild(i)->accept(painter);
        painter.popFromNodePath();
    }
}

bool isPainted(const osg::Node& node)
{
    bool painted = false;
    return node.getUserValue(kPainted, painted) && painted;
}

void restorePaintedPart(osg::Node& node)
{
    osg::UserDataContainer& container = *node.getUserDataContainer();
    const unsigned int mark = container.getUserObjectIndex(kPainted);
    container.removeUserObject(mark);
    auto* own =
        mark > 0 ? dynamic_cast<osg::StateSet*>(container.getUserObject(mark - 1)) : nullptr;
    node.setStateSet(own);
    if (own) container.removeUserObject(mark - 1);
    if (container.getNumUserObjects() == 0 && container.getNumDescriptions() == 0 &&
        !container.getUserData())
        node.setUserDataContainer(nullptr);
}

}  // namespace osgFbrdf
