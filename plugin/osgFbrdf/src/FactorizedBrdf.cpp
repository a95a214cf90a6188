#include <osgFbrdf/FactorizedBrdf.h>

#include "DiffuseTechnique.h"
#include "FileWatch.h"
#include "PassTechnique.h"
#include "SceneLights.h"

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
    auto result = reader->readObject(file, options);
    osg::ref_ptr<MaterialObject> material = dynamic_cast<MaterialObject*>(result.getObject());
    if (!material)
        OSG_WARN << "osgFbrdf: "
                 << (result.message().empty() ? file + ": found no such file, expected a material"
                                              : result.message())
                 << std::endl;
    return material;
}

FactorizedBrdf::FactorizedBrdf() : watch_(std::make_unique<FileWatch>()) {}
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
      watch_(std::make_unique<FileWatch>(*other.watch_))
{
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
    const Lock lock(definition_);
    defined_ = false;
    refuse("");
    dirtyTechniques();
}

std::string FactorizedBrdf::refusal() const
{
    const Lock lock(reporting_);
    return refusal_;
}

void FactorizedBrdf::refuse(const std::string& reason) const
{
    const Lock lock(reporting_);
    refusal_ = reason;
}

DrawReport FactorizedBrdf::lastReport() const
{
    const Lock lock(reporting_);
    return report_;
}

void FactorizedBrdf::report(const DrawReport& report)
{
    const Lock lock(reporting_);
    if (!report.reason.empty() && report.reason != report_.reason)
        OSG_WARN << "osgFbrdf: "
                 << (!getName().empty()       ? getName()
                     : !materialFile_.empty() ? materialFile_
                                              : "an effect without a name")
                 << ": " << report.technique << " is drawn: " << report.reason << std::endl;
    report_ = report;
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

bool FactorizedBrdf::define_techniques()
{
    for (const auto kind :
         {fbrdf::Technique::single, fbrdf::Technique::batched, fbrdf::Technique::twoLookup})
        addTechnique(new PassTechnique(*this, kind));
    addTechnique(new DiffuseTechnique(*this));
    return true;
}

// Visitors that neither cull nor compile see the children once, whatever the number of passes.
void FactorizedBrdf::traverse(osg::NodeVisitor& visitor)
{
    if (reloading_ && visitor.getVisitorType() == osg::NodeVisitor::UPDATE_VISITOR)
        reloadWhenChanged(visitor);
    const bool compiles = dynamic_cast<osgUtil::GLObjectsVisitor*>(&visitor) != nullptr;
    if (!visitor.asCullVisitor() && !compiles) return inherited_traverse(visitor);
    if (!defined_) {
        // osgFX defines techniques without a lock; two threads may cull this effect for the first
        // time at once.
        const Lock lock(definition_);
        if (!defined_) {
            compiles ? Effect::traverse(visitor) : cull(visitor);
            defined_ = true;
            return;
        }
    }
    compiles ? Effect::traverse(visitor) : cull(visitor);
}

// osgFX chooses while it draws, so before the first frame is drawn nothing is chosen and the
// children would be left out: draw them by the best technique.
void FactorizedBrdf::cull(osg::NodeVisitor& visitor)
{
    if (!getEnabled()) return inherited_traverse(visitor);
    auto& culling = *visitor.asCullVisitor();
    const int before = sceneLights(culling).techniqueTraversals;
    Effect::traverse(visitor);
    if (sceneLights(culling).techniqueTraversals == before && getNumTechniques() > 0)
        getTechnique(kSinglePass)->traverse(visitor, this);
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
    const Lock lock(reporting_);
    ++releases_;
}

}  // namespace osgFbrdf
