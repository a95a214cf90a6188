#include <osgFbrdf/FactorizedBrdf.h>

#include "DiffuseTechnique.h"
#include "FileWatch.h"
#include "KeptTransforms.h"
#include "PassTechnique.h"
#include "ShapeCameras.h"
#include "Surfaces.h"
#include "TechniqueChoice.h"

#include <osg/Notify>
#include <osgDB/FileUtils>
#include <osgDB/Registry>
#include <osgUtil/CullVisitor>
#include <osgUtil/GLObjectsVisitor>

#include <OpenThreads/ScopedLock>

#include <algorithm>
#include <cmath>

namespace osgFbrdf {
namespace {

using Lock = OpenThreads::ScopedLock<OpenThreads::Mutex>;

}  // namespace

osg::ref_ptr<MaterialObject> readMaterialObject(const std::string& file,
                                                const osgDB::Options* options)
{
    auto* reader = osgDB::Registry::instance()->getReaderWriterForExtension("fbrdf");
    if (!reader) {
        OSG_WARN << "osgFbrdf: " << file
                 << ": found no plugin osgdb_fbrdf to read it with, expected "
                 << "it in OSG_LIBRARY_PATH" << std::endl;
        return nullptr;
    }
    const osg::ref_ptr<osgDB::Options> local =
        options ? new osgDB::Options(*options) : new osgDB::Options;
    local->setPluginStringData(kReadMaterial, "1");
    auto result = reader->readObject(file, local);
    osg::ref_ptr<MaterialObject> material = dynamic_cast<MaterialObject*>(result.getObject());
    if (!material)
        OSG_WARN << "osgFbrdf: "
                 << (result.message().empty() ? file + ": found no such file, expected a material"
                                              : result.message())
                 << std::endl;
    return material;
}

FactorizedBrdf::FactorizedBrdf()
    : watch_(std::make_unique<FileWatch>()), choice_(new TechniqueChoice)
{
    FactorizedBrdf::define_techniques();
}

FactorizedBrdf::~FactorizedBrdf() = default;

FactorizedBrdf::FactorizedBrdf(const FactorizedBrdf& other, const osg::CopyOp& op)
    : osgFX::Effect(other, op),
      materialFile_(other.materialFile_),
      material_(other.material_),
      exposure_(other.exposure_),
      lightsPerPass_(other.lightsPerPass_),
      lookupsPerPass_(other.lookupsPerPass_),
      firstTextureUnit_(other.firstTextureUnit_),
      floatTarget_(other.floatTarget_),
      derivedTangents_(other.derivedTangents_),
      transfer_(other.transfer_),
      watch_(std::make_unique<FileWatch>(*other.watch_)),
      choice_(new TechniqueChoice)
{
    FactorizedBrdf::define_techniques();
    setReloading(other.reloading_);
}

bool FactorizedBrdf::setMaterialFile(const std::string& file, const osgDB::Options* options)
{
    materialFile_ = file;
    watch_->follow(file.empty() ? "" : osgDB::findDataFile(file, options));
    material_ = file.empty() ? nullptr : readMaterialObject(file, options);
    changed();
    return material_.valid();
}

bool FactorizedBrdf::reloadMaterial(const osgDB::Options* options)
{
    return !materialFile_.empty() && replaceMaterial(readMaterialObject(materialFile_, options));
}

/// Null changes nothing.
bool FactorizedBrdf::replaceMaterial(const osg::ref_ptr<MaterialObject>& material)
{
    if (!material) return false;
    material_ = material;
    changed();
    return true;
}

void FactorizedBrdf::setReloading(bool reloading)
{
    if (reloading == reloading_) return;
    reloading_ = reloading;
    const unsigned int others = getNumChildrenRequiringUpdateTraversal();
    setNumChildrenRequiringUpdateTraversal(reloading ? others + 1 : others - 1);
}

void FactorizedBrdf::reloadWhenChanged(const osg::NodeVisitor& visitor)
{
    const osg::FrameStamp* stamp = visitor.getFrameStamp();
    if (stamp && watch_->changed(stamp->getReferenceTime()))
        replaceMaterial(readMaterialObject(watch_->path()));
}

void FactorizedBrdf::setMaterial(MaterialObject* material)
{
    material_ = material;
    materialFile_ = material ? material->fileName() : "";
    watch_->follow(materialFile_.empty() ? "" : osgDB::findDataFile(materialFile_));
    changed();
}

void FactorizedBrdf::setTransfer(fbrdf::Transfer transfer)
{
    transfer_ = transfer;
    changed();
}

void FactorizedBrdf::setLightsPerPass(int lights)
{
    lightsPerPass_ = std::max(1, lights);
    changed();
}

void FactorizedBrdf::setLookupsPerPass(int lookups)
{
    lookupsPerPass_ = std::max(0, lookups);
    changed();
}

void FactorizedBrdf::setFirstTextureUnit(int unit)
{
    firstTextureUnit_ = std::max(0, unit);
    changed();
}

void FactorizedBrdf::setFloatTarget(bool isFloat)
{
    floatTarget_ = isFloat;
    changed();
}

/// What contexts said about the techniques no longer holds.
void FactorizedBrdf::changed()
{
    {
        const Lock lock(reporting_);
        said_.clear();
    }
    choice_->forget();
}

std::string FactorizedBrdf::refusal() const
{
    return choice_->refusal();
}

void FactorizedBrdf::refuse(const std::string& reason) const
{
    choice_->refuse(reason);
}

DrawReport FactorizedBrdf::lastReport() const
{
    const Lock lock(reporting_);
    return report_;
}

// A warning a frame would drown the log: views and frames may differ in what they can draw, and
// numbers of lights change.
void FactorizedBrdf::warnOnce(const std::string& kind, const std::string& problem)
{
    if (!said_.insert(kind).second) return;
    std::string who = getName().empty() ? "an effect without a name" : "'" + getName() + "'";
    if (!materialFile_.empty())
        who = getName().empty() ? materialFile_ : who + ", " + materialFile_;
    OSG_WARN << "osgFbrdf: " << who << ": " << problem << std::endl;
}

void FactorizedBrdf::report(const DrawReport& report)
{
    const Lock lock(reporting_);
    if (!report.reason.empty())
        warnOnce(report.reason, report.technique + " is drawn: " + report.reason);
    // Who forces the fallback knows that it has eight lights.
    if (report.lightsDropped > 0 && getSelectedTechnique() != kDiffuseFallback)
        warnOnce("lights", "lights are left out: found " +
                               std::to_string(report.lightsDropped + report.lightsUsed) + ", " +
                               std::to_string(report.lightsUsed) +
                               " of which are valid and within what the technique can draw");
    report_ = report;
}

void FactorizedBrdf::uses(Surfaces& surfaces) const
{
    const Lock lock(reporting_);
    if (std::find(surfaces_.begin(), surfaces_.end(), &surfaces) != surfaces_.end()) return;
    surfaces_.erase(std::remove_if(surfaces_.begin(), surfaces_.end(),
                                   [](const auto& known) { return !known.valid(); }),
                    surfaces_.end());
    surfaces_.emplace_back(&surfaces);
}

bool FactorizedBrdf::arraysReleased(unsigned int contextId) const
{
    const Lock lock(reporting_);
    const auto known = forgotten_.find(contextId);
    return releases_ != (known == forgotten_.end() ? 0 : known->second);
}

void FactorizedBrdf::arraysForgotten(unsigned int contextId)
{
    const Lock lock(reporting_);
    forgotten_[contextId] = releases_;
}

// Once, by the constructors: they only look at what the effect is when they are used.
bool FactorizedBrdf::define_techniques()
{
    for (const auto kind :
         {fbrdf::Technique::single, fbrdf::Technique::batched, fbrdf::Technique::twoLookup})
        addTechnique(new PassTechnique(*this, kind));
    addTechnique(new DiffuseTechnique(*this));
    return true;
}

std::vector<ContextNeeds> FactorizedBrdf::needs() const
{
    std::vector<ContextNeeds> needs;
    for (int i = 0; i < kDiffuseFallback; ++i)
        needs.push_back(static_cast<const PassTechnique&>(*getTechnique(i)).needs());
    return needs;
}

// Not osgFX::Effect's, which chooses in ways that threads do not bear (see TechniqueChoice.h).
// Visitors that do not cull see the children once, whatever the number of passes.
void FactorizedBrdf::traverse(osg::NodeVisitor& visitor)
{
    if (reloading_ && visitor.getVisitorType() == osg::NodeVisitor::UPDATE_VISITOR)
        reloadWhenChanged(visitor);
    if (auto* culling = visitor.asCullVisitor(); culling && getEnabled()) return cull(*culling);
    if (auto* compiling = dynamic_cast<osgUtil::GLObjectsVisitor*>(&visitor)) compile(*compiling);
    keepTransformsAboveTangents(visitor, *this);
    inherited_traverse(visitor);
}

void FactorizedBrdf::compile(osgUtil::GLObjectsVisitor& visitor)
{
    // Others only collect what is to be compiled: no context is current.
    constexpr auto kCompiles = osgUtil::GLObjectsVisitor::COMPILE_STATE_ATTRIBUTES;
    if (visitor.getState() && (visitor.getMode() & kCompiles))
        choice_->ask(*visitor.getState(), needs());
}

void FactorizedBrdf::cull(osgUtil::CullVisitor& visitor)
{
    const osg::Camera* camera = visitor.getCurrentCamera();
    if (camera && drawsShapes(*camera)) return inherited_traverse(visitor);
    const osg::State* state = visitor.getState();
    osg::ref_ptr<osg::StateSet> question;
    if (state && !choice_->asked(state->getContextID())) question = choice_->question(needs());
    const int selected = getSelectedTechnique();
    const int index = selected == AUTO_DETECT ? choice_->index() : selected;
    if (question) visitor.pushStateSet(question);
    getTechnique(std::clamp(index, 0, getNumTechniques() - 1))->traverse(visitor, this);
    if (question) visitor.popStateSet();
}

void FactorizedBrdf::resizeGLObjectBuffers(unsigned int maxSize)
{
    Effect::resizeGLObjectBuffers(maxSize);
    if (material_) material_->resizeGLObjectBuffers(maxSize);
}

void FactorizedBrdf::releaseGLObjects(osg::State* state) const
{
    Effect::releaseGLObjects(state);
    if (material_) material_->releaseGLObjects(state);
    state ? choice_->forget(state->getContextID()) : choice_->forget();
    const Lock lock(reporting_);
    for (const auto& known : surfaces_) {
        osg::ref_ptr<Surfaces> surfaces;
        if (known.lock(surfaces)) surfaces->releaseGLObjects(state);
    }
    ++releases_;
}

}  // namespace osgFbrdf
