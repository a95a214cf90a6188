#include <osgFbrdf/PlainForm.h>

#include "EnvironmentCube.h"
#include "GlLights.h"
#include "PartNames.h"
#include "PlainParts.h"

#include <osgFbrdf/AreaLights.h>
#include <osgFbrdf/EnvironmentLight.h>
#include <osgFbrdf/FactorizedBrdf.h>
#include <osgFbrdf/PointLights.h>

#include <fbrdf/base/Found.h>

#include <osg/LightModel>
#include <osg/LightSource>
#include <osg/Notify>
#include <osg/ValueObject>
#include <osgDB/Registry>

#include <algorithm>
#include <locale>
#include <map>
#include <sstream>

namespace osgFbrdf {
namespace {

/// Key of the user value of a group that replaces a node of ours.
constexpr const char* kRecord = "osgFbrdf";
/// Record of the group that turns the lights on.
constexpr const char* kLit = "lit";
/// Name of the group of LightSources.
constexpr const char* kSources = "osgFbrdf plain lights";

osgDB::ReaderWriter* asciiFormat()
{
    return osgDB::Registry::instance()->getReaderWriterForExtension("osgt");
}

/// The node without its children as text.
template <class Node>
std::string recordOf(const Node& node)
{
    const osg::ref_ptr<Node> bare = new Node(node, osg::CopyOp::SHALLOW_COPY);
    bare->removeChildren(0, bare->getNumChildren());
    std::ostringstream text;
    text.imbue(std::locale::classic());  // a host's global locale may write 0,5 and 1.000
    const osg::ref_ptr<osgDB::Options> options = new osgDB::Options("Ascii");
    auto* format = asciiFormat();
    if (!format || !format->writeObject(*bare, text, options).success())
        OSG_WARN << "osgFbrdf: " << node.getName()
                 << ": found no plugin osgdb_osg to record it with; it stays plain" << std::endl;
    return text.str();
}

/// A group with the same children, name, mask and state, and the record of the node.
template <class Node>
osg::ref_ptr<osg::Group> groupFor(const Node& node)
{
    const osg::ref_ptr<osg::Group> group = new osg::Group(node, osg::CopyOp::SHALLOW_COPY);
    if (node.getStateSet()) group->setStateSet(osg::clone(node.getStateSet()));
    if (node.getUserDataContainer())
        group->setUserDataContainer(
            osg::clone(node.getUserDataContainer(), osg::CopyOp::DEEP_COPY_USERDATA));
    group->setUserValue(kRecord, recordOf(node));
    return group;
}

/// ambient: see plainMaterial().
osg::ref_ptr<osg::Group> plainEffect(FactorizedBrdf& effect, bool ambient)
{
    paintParts(effect, ambient);
    const osg::ref_ptr<osg::Group> group = groupFor(effect);
    if (drawsRest(effect))
        group->getOrCreateStateSet()->setAttributeAndModes(
            plainMaterial(effect, ambient),
            osg::StateAttribute::ON | osg::StateAttribute::OVERRIDE);
    return group;
}

using Lights = std::vector<std::pair<fbrdf::Light, int>>;  ///< with the number in GL

/// node: one of PointLights or AreaLights.
osg::ref_ptr<osg::Group> plainLights(const osg::Group& node, const Lights& lights)
{
    const auto* areas = dynamic_cast<const AreaLights*>(&node);
    const osg::ref_ptr<osg::Group> group =
        areas ? groupFor(*areas) : groupFor(static_cast<const PointLights&>(node));
    const osg::ref_ptr<osg::Group> sources = new osg::Group;
    sources->setName(kSources);
    for (const auto& [light, number] : lights) {
        const osg::ref_ptr<osg::LightSource> source = new osg::LightSource;
        source->setLight(glLight(light, number));
        sources->addChild(source);
    }
    group->addChild(sources);
    return group;
}

void replace(osg::Node& node, osg::Node& by)
{
    const osg::Node::ParentList parents = node.getParents();
    for (osg::Group* parent : parents) parent->replaceChild(&node, &by);
}

/// The valid lights of PointLights or AreaLights, as far as OpenGL can have them.
std::vector<fbrdf::Light> lightsIn(const osg::Group& node)
{
    std::vector<fbrdf::Light> lights;
    if (const auto* points = dynamic_cast<const PointLights*>(&node))
        for (const fbrdf::Light& light : points->getLights())
            if (fbrdf::isValid(light)) lights.push_back(light);
    if (const auto* areas = dynamic_cast<const AreaLights*>(&node))
        for (const fbrdf::AreaLight& light : areas->getLights())
            if (fbrdf::whyInvalid(light).empty()) lights.push_back(pointLightOf(light));
    return lights;
}

struct PartsOfScene : public osg::NodeVisitor {
    PartsOfScene() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) {}
    void apply(osg::Node& node) override
    {
        if (isPainted(node)) painted.emplace_back(&node);
        traverse(node);
    }
    void apply(osg::Group& group) override
    {
        std::string record;
        if (auto* effect = dynamic_cast<FactorizedBrdf*>(&group)) effects.emplace_back(effect);
        if (dynamic_cast<PointLights*>(&group) || dynamic_cast<AreaLights*>(&group))
            lights.emplace_back(&group);
        if (auto* node = dynamic_cast<EnvironmentLight*>(&group)) environments.emplace_back(node);
        if (group.getUserValue(kRecord, record)) records.emplace_back(&group);
        apply(static_cast<osg::Node&>(group));
    }
    void apply(osg::LightSource& source) override
    {
        if (source.getLight()) taken.push_back(source.getLight()->getLightNum());
        traverse(source);
    }
    std::vector<osg::ref_ptr<FactorizedBrdf>> effects;
    std::vector<osg::ref_ptr<osg::Group>> lights;  ///< PointLights and AreaLights
    std::vector<osg::ref_ptr<EnvironmentLight>> environments;
    std::vector<osg::ref_ptr<osg::Group>> records;
    std::vector<osg::ref_ptr<osg::Node>> painted;
    std::vector<int> taken;  ///< numbers of the scene's own osg::Lights
};

/// The lights of each node that get one of OpenGL's numbers: the most intense of all nodes.
std::vector<Lights> chosenLights(const PartsOfScene& found)
{
    struct Candidate {
        size_t node;
        fbrdf::Light light;
    };
    std::vector<Candidate> candidates;
    for (size_t n = 0; n < found.lights.size(); ++n)
        for (const fbrdf::Light& light : lightsIn(*found.lights[n]))
            candidates.push_back({n, light});
    std::stable_sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
        return luminance(a.light.intensity) > luminance(b.light.intensity);
    });
    std::vector<Lights> chosen(found.lights.size());
    auto next = candidates.begin();
    for (int number = 0; number < kMostGlLights && next != candidates.end(); ++number)
        if (std::count(found.taken.begin(), found.taken.end(), number) == 0) {
            chosen[next->node].emplace_back(next->light, number);
            ++next;
        }
    return chosen;
}

/// The light of an environment as if it came from all sides alike; black where there is none.
osg::Vec4f ambientOf(const PartsOfScene& found)
{
    for (const auto& environment : found.environments)
        if (environment->valid()) {
            const fbrdf::Vec3f& mean = environment->cube()->mean();
            return {osg::componentMultiply(environment->getIntensity(),
                                           osg::Vec3f(mean.x, mean.y, mean.z)),
                    1.0f};
        }
    return {0.0f, 0.0f, 0.0f, 1.0f};
}

/// The root under a group that turns the chosen lights on.
osg::ref_ptr<osg::Group> lit(osg::Node& root, const std::vector<Lights>& chosen,
                             const osg::Vec4f& ambient)
{
    const osg::ref_ptr<osg::Group> group = new osg::Group;
    if (ambient != osg::Vec4f(0.0f, 0.0f, 0.0f, 1.0f)) {
        const osg::ref_ptr<osg::LightModel> model = new osg::LightModel;
        model->setAmbientIntensity(ambient);
        group->getOrCreateStateSet()->setAttribute(model);
    }
    group->setUserValue(kRecord, std::string(kLit));
    for (const Lights& lights : chosen)
        for (const auto& light : lights)
            group->getOrCreateStateSet()->setMode(GL_LIGHT0 + static_cast<GLenum>(light.second),
                                                  osg::StateAttribute::ON);
    group->addChild(&root);
    return group;
}

/// The node that the record of a group describes, with the children of the group; null, with a
/// warning, where this library cannot read the record.
osg::ref_ptr<osg::Group> nodeFrom(osg::Group& plain, const std::string& record,
                                  const osgDB::Options* given)
{
    const osg::ref_ptr<osgDB::Options> options =
        given ? new osgDB::Options(*given) : new osgDB::Options;
    options->setOptionString("Ascii");
    std::istringstream text(record);
    text.imbue(std::locale::classic());
    auto* format = asciiFormat();
    auto result = format ? format->readObject(text, options) : osgDB::ReaderWriter::ReadResult();
    const osg::ref_ptr<osg::Group> node = dynamic_cast<osg::Group*>(result.getObject());
    if (!node) {
        OSG_WARN << "osgFbrdf: " << plain.getName() << ": "
                 << fbrdf::Found("a record that cannot be read").expected("an effect or lights")
                 << std::endl;
        return nullptr;
    }
    for (unsigned int i = 0; i < plain.getNumChildren(); ++i)
        if (plain.getChild(i)->getName() != kSources) node->addChild(plain.getChild(i));
    return node;
}

/// Makes equal materials without a file one object: each effect has recorded a copy of its own.
void shareMaterials(const std::vector<osg::ref_ptr<FactorizedBrdf>>& effects)
{
    auto* format = osgDB::Registry::instance()->getReaderWriterForExtension("fbrdf");
    std::map<std::string, MaterialObject*> byBytes;
    for (const auto& effect : effects) {
        std::ostringstream bytes;
        if (!format || !effect->getMaterial() || !effect->getMaterialFile().empty() ||
            !format->writeObject(*effect->getMaterial(), bytes).success())
            continue;
        const auto [entry, isFirst] = byBytes.emplace(bytes.str(), effect->getMaterial());
        if (!isFirst) effect->setMaterial(entry->second);
    }
}

}  // namespace

osg::ref_ptr<osg::Node> plainForm(const osg::Node& scene)
{
    const osg::ref_ptr<osg::Group> above = new osg::Group;
    above->addChild(osg::clone(&scene, osg::CopyOp::DEEP_COPY_NODES));
    PartsOfScene found;
    above->accept(found);
    const bool hasEnvironment = !found.environments.empty();
    for (const auto& effect : found.effects)
        replace(*effect, *plainEffect(*effect, hasEnvironment));
    for (const auto& node : found.environments) replace(*node, *groupFor(*node));
    const auto chosen = chosenLights(found);
    for (size_t n = 0; n < chosen.size(); ++n)
        replace(*found.lights[n], *plainLights(*found.lights[n], chosen[n]));
    const osg::ref_ptr<osg::Node> root = above->getChild(0);
    above->removeChildren(0, 1);
    return chosen.empty() && !hasEnvironment
               ? root
               : osg::ref_ptr<osg::Node>(lit(*root, chosen, ambientOf(found)));
}

osg::ref_ptr<osg::Node> restored(osg::Node& plain, const osgDB::Options* options)
{
    const osg::ref_ptr<osg::Group> above = new osg::Group;
    above->addChild(&plain);
    PartsOfScene found;
    above->accept(found);
    std::vector<osg::ref_ptr<FactorizedBrdf>> effects;
    for (const auto& group : found.records) {
        std::string record;
        group->getUserValue(kRecord, record);
        const bool isLit = record == kLit && group->getNumChildren() == 1;
        const osg::ref_ptr<osg::Node> node =
            isLit ? group->getChild(0) : nodeFrom(*group, record, options).get();
        if (node) replace(*group, *node);
        auto* effect = dynamic_cast<FactorizedBrdf*>(node.get());
        if (!effect) continue;
        effects.emplace_back(effect);
        for (FactorizedBrdf* part : effect->effectsOfParts()) effects.emplace_back(part);
    }
    for (const auto& node : found.painted) restorePaintedPart(*node);
    shareMaterials(effects);
    return above->getChild(0);
}

}  // namespace osgFbrdf
