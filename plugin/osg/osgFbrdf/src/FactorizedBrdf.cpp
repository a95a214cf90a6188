#include <osgFbrdf/FactorizedBrdf.h>

#include "DiffuseTechnique.h"
#include "EffectInternals.h"
#include "FileWatch.h"
#include "KeptTransforms.h"
#include "PassTechnique.h"
#include "ShapeCameras.h"
#include "ViewState.h"

#include <fbrdf/base/Found.h>

#include <osg/Notify>
#include <osgDB/FileUtils>
#include <osgDB/Registry>
#include <osgUtil/CullVisitor>
#include <osgUtil/GLObjectsVisitor>

#include <algorithm>
#include <cmath>

namespace osgFbrdf {

namespace {

static_assert(kSinglePass == static_cast<int>(fbrdf::Technique::single) &&
                  kBatched == static_cast<int>(fbrdf::Technique::batched) &&
                  kTwoLookups == static_cast<int>(fbrdf::Technique::twoLookup),
              "techniques of an effect have the order of the runtime's");

/// how: kShared or kAnew; name: of the effect, for the log.
osg::ref_ptr<MaterialObject> read(const std::string& file, const osgDB::Options* options,
                                  const char* how, const std::string& name)
{
    const std::string where = "osgFbrdf: " + (name.empty() ? "" : "'" + name + "', ");
    auto* reader = osgDB::Registry::instance()->getReaderWriterForExtension("fbrdf");
    if (!reader) {
        OSG_WARN << where << file << ": "
                 << fbrdf::Found("no plugin osgdb_fbrdf to read it with")
                        .expected("it in OSG_LIBRARY_PATH")
                 << std::endl;
        return nullptr;
    }
    const osg::ref_ptr<osgDB::Options> local =
        options ? new osgDB::Options(*options) : new osgDB::Options;
    local->setPluginStringData(kReadMaterial, how);
    auto result = reader->readObject(file, local);
    osg::ref_ptr<MaterialObject> material = dynamic_cast<MaterialObject*>(result.getObject());
    if (!material)
        OSG_WARN << where
                 << (result.message().empty()
                         ? file + ": " + fbrdf::Found("no such file").expected("a material")
                         : result.message())
                 << std::endl;
    return material;
}

}  // namespace

osg::ref_ptr<MaterialObject> readMaterialObject(const std::string& file,
                                                const osgDB::Options* options)
{
    return read(file, options, kShared, "");
}

FactorizedBrdf::FactorizedBrdf()
    : watch_(std::make_unique<FileWatch>()), internals_(new EffectInternals)
{
    FactorizedBrdf::define_techniques();
}

FactorizedBrdf::~FactorizedBrdf() = default;

FactorizedBrdf::FactorizedBrdf(const FactorizedBrdf& other, const osg::CopyOp& op)
    : osgFX::Effect(other, op),
      materialFile_(other.materialFile_),
      material_(other.material_),
      watch_(std::make_unique<FileWatch>(*other.watch_)),
      internals_(new EffectInternals)
{
    FactorizedBrdf::define_techniques();
    takeProperties(other);
    setReloading(other.reloading_);
    for (const ModelPart& part : other.parts_)
        parts_.push_back({part.name, (op.getCopyFlags() & osg::CopyOp::DEEP_COPY_NODES)
                                         ? osg::clone(part.effect.get(), op)
                                         : part.effect.get()});
}

/// All but material, name, children and parts.
void FactorizedBrdf::takeProperties(const FactorizedBrdf& other)
{
    exposure_ = other.exposure_;
    lightsPerPass_ = other.lightsPerPass_;
    lookupsPerPass_ = other.lookupsPerPass_;
    firstTextureUnit_ = other.firstTextureUnit_;
    freeTextureUnits_ = other.freeTextureUnits_;
    floatTarget_ = other.floatTarget_;
    derivedTangents_ = other.derivedTangents_;
    preciseFiltering_ = other.preciseFiltering_;
    textures_ = other.textures_;
    vertexHook_ = other.vertexHook_;
    transfer_ = other.transfer_;
    accumulation_ = other.accumulation_;
    selectTechnique(other.getSelectedTechnique());
}

bool FactorizedBrdf::setMaterialFile(const std::string& file, const osgDB::Options* options)
{
    materialFile_ = file;
    watch_->follow(file.empty() ? "" : osgDB::findDataFile(file, options));
    material_ = file.empty() ? nullptr : read(file, options, kShared, getName());
    changed();
    return material_.valid();
}

bool FactorizedBrdf::reloadMaterial(const osgDB::Options* options)
{
    return !materialFile_.empty() &&
           replaceMaterial(read(materialFile_, options, kAnew, getName()));
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
        replaceMaterial(read(watch_->path(), nullptr, kAnew, getName()));
}

void FactorizedBrdf::setMaterial(MaterialObject* material, const osgDB::Options* options)
{
    material_ = material;
    materialFile_ = material ? material->fileName() : "";
    watch_->follow(materialFile_.empty() ? "" : osgDB::findDataFile(materialFile_, options));
    changed();
}

template <class Value>
void FactorizedBrdf::setOfParts(void (FactorizedBrdf::*set)(Value), Value value)
{
    for (FactorizedBrdf* effect : effectsOfParts()) (effect->*set)(value);
}

void FactorizedBrdf::setExposure(float exposure)
{
    exposure_ = exposure;
    setOfParts(&FactorizedBrdf::setExposure, exposure);
}

void FactorizedBrdf::setDerivedTangents(bool derived)
{
    derivedTangents_ = derived;
    setOfParts(&FactorizedBrdf::setDerivedTangents, derived);
}

void FactorizedBrdf::setPreciseFiltering(bool precise)
{
    preciseFiltering_ = precise;
    setOfParts(&FactorizedBrdf::setPreciseFiltering, precise);
}

void FactorizedBrdf::setModelTextures(const ModelTextures& textures)
{
    textures_ = textures;
    changed();
    setOfParts<const ModelTextures&>(&FactorizedBrdf::setModelTextures, textures);
}

void FactorizedBrdf::setVertexHook(const VertexHook& hook)
{
    vertexHook_ = hook;
    changed();
    setOfParts<const VertexHook&>(&FactorizedBrdf::setVertexHook, hook);
}

void FactorizedBrdf::setTransfer(fbrdf::Transfer transfer)
{
    transfer_ = transfer;
    changed();
    setOfParts(&FactorizedBrdf::setTransfer, transfer);
}

void FactorizedBrdf::setLightsPerPass(int lights)
{
    lightsPerPass_ = std::max(1, lights);
    changed();
    setOfParts(&FactorizedBrdf::setLightsPerPass, lights);
}

void FactorizedBrdf::setLookupsPerPass(int lookups)
{
    lookupsPerPass_ = std::max(0, lookups);
    changed();
    setOfParts(&FactorizedBrdf::setLookupsPerPass, lookups);
}

void FactorizedBrdf::setFirstTextureUnit(int unit)
{
    firstTextureUnit_ = std::max(0, unit);
    changed();
    setOfParts(&FactorizedBrdf::setFirstTextureUnit, unit);
}

void FactorizedBrdf::setFreeTextureUnits(const std::set<int>& units)
{
    freeTextureUnits_ = units;
    changed();
    setOfParts<const std::set<int>&>(&FactorizedBrdf::setFreeTextureUnits, units);
}

void FactorizedBrdf::setFloatTarget(bool isFloat)
{
    floatTarget_ = isFloat;
    changed();
    setOfParts(&FactorizedBrdf::setFloatTarget, isFloat);
}

void FactorizedBrdf::setAccumulation(fbrdf::ColourFormat format)
{
    using Format = fbrdf::ColourFormat;
    accumulation_ = format == Format::rgba16f || format == Format::rgba8 ? format : Format::rgba32f;
    changed();
    setOfParts(&FactorizedBrdf::setAccumulation, accumulation_);
}

/// Contexts are asked anew what they can draw, and warnings may come again.
void FactorizedBrdf::changed()
{
    internals_->log.forgetWarnings();
    internals_->choice->forget();
}

DrawReport FactorizedBrdf::lastReport() const
{
    return internals_->log.last();
}

// Called once, by the constructors: techniques look at the effect only when they are used.
bool FactorizedBrdf::define_techniques()
{
    for (const fbrdf::Technique kind : fbrdf::allTechniques())
        addTechnique(new PassTechnique(*this, *internals_, kind));
    addTechnique(new DiffuseTechnique);
    return true;
}

std::vector<ContextNeeds> FactorizedBrdf::needs() const
{
    std::vector<ContextNeeds> needs;
    for (int i = 0; i < kDiffuseFallback; ++i)
        needs.push_back(static_cast<const PassTechnique&>(*getTechnique(i)).needs());
    return needs;
}

// This replaces the traversal of osgFX::Effect, which chooses in ways that threads do not bear (see
// TechniqueChoice.h).
// Visitors that do not cull see the children once, whatever the number of passes.
void FactorizedBrdf::traverse(osg::NodeVisitor& visitor)
{
    if (reloading_ && visitor.getVisitorType() == osg::NodeVisitor::UPDATE_VISITOR) {
        reloadWhenChanged(visitor);
        for (FactorizedBrdf* effect : effectsOfParts()) effect->reloadWhenChanged(visitor);
    }
    if (auto* culling = visitor.asCullVisitor(); culling && getEnabled()) return cull(*culling);
    if (auto* compiling = dynamic_cast<osgUtil::GLObjectsVisitor*>(&visitor)) compile(*compiling);
    // It would make nodes one that only their names tell apart.
    if (!parts_.empty() && keepTransformsAbove(visitor)) return;
    keepTransformsAboveTangents(visitor, *this);
    inherited_traverse(visitor);
}

void FactorizedBrdf::compile(osgUtil::GLObjectsVisitor& visitor)
{
    // Others only collect what is to be compiled: no context is current.
    constexpr auto kCompiles = osgUtil::GLObjectsVisitor::COMPILE_STATE_ATTRIBUTES;
    if (visitor.getState() && (visitor.getMode() & kCompiles))
        internals_->choice->ask(*visitor.getState(), needs());
    for (FactorizedBrdf* effect : effectsOfParts()) effect->compile(visitor);
}

void FactorizedBrdf::cull(osgUtil::CullVisitor& visitor)
{
    const osg::Camera* camera = visitor.getCurrentCamera();
    if (camera && drawsShapes(*camera)) return inherited_traverse(visitor);
    if (!parts_.empty() || textures_.hasAlpha()) return cullParts(visitor);
    cullAs(visitor, *this, [&] { inherited_traverse(visitor); });
}

void FactorizedBrdf::cullAs(osgUtil::CullVisitor& visitor, const FactorizedBrdf& model,
                            const std::function<void()>& cullModel,
                            const std::function<void()>& cullBlended)
{
    const osg::State* state = visitor.getState();
    osg::ref_ptr<osg::StateSet> probe;
    if (state && !internals_->choice->asked(state->getContextID()))
        probe = internals_->choice->probe(needs());
    int selected = getSelectedTechnique();
    if (selected == AUTO_DETECT) selected = model.getSelectedTechnique();
    const int index = std::clamp(selected == AUTO_DETECT ? internals_->choice->index() : selected,
                                 0, getNumTechniques() - 1);
    if (probe) visitor.pushStateSet(probe);
    static_cast<EffectTechnique&>(*getTechnique(index))
        .cull({visitor, ViewState::of(visitor), *this, *internals_, model, cullModel, cullBlended,
               selected});
    if (probe) visitor.popStateSet();
}

void FactorizedBrdf::resizeGLObjectBuffers(unsigned int maxSize)
{
    Effect::resizeGLObjectBuffers(maxSize);
    if (material_) material_->resizeGLObjectBuffers(maxSize);
    internals_->diffuse->resizeGLObjectBuffers(maxSize);
    for (FactorizedBrdf* effect : effectsOfParts()) effect->resizeGLObjectBuffers(maxSize);
}

void FactorizedBrdf::releaseGLObjects(osg::State* state) const
{
    Effect::releaseGLObjects(state);
    if (material_) material_->releaseGLObjects(state);
    internals_->diffuse->releaseGLObjects(state);
    state ? internals_->choice->forget(state->getContextID()) : internals_->choice->forget();
    internals_->objects.release(state);
    for (const FactorizedBrdf* effect : effectsOfParts()) effect->releaseGLObjects(state);
}

}  // namespace osgFbrdf
