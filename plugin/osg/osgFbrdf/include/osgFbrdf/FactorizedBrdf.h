// FactorizedBrdf.h - the effect: everything below it is drawn with one factored material, lit by
// every osgFbrdf::PointLights and every osg::LightSource of the scene.
//
// Techniques, best first: "single pass", "batched", "two look-ups per pass", "diffuse fallback".
// Each needs less than the one before, so a choice that suits one context suits a lesser one; every
// context is asked when it first draws. selectTechnique() forces one. Cameras of shadow maps, which
// draw no colour or override materials, draw the children as they are. Plans and shaders are the
// runtime's (fbrdf/plan, fbrdf/shaders).
//
// Lights. An osg::Light is read so that a white Lambertian looks as it does in fixed function:
// diffuse colour, attenuation, cut-off and exponent; not while its mode GL_LIGHTn is off in a state
// set above. Beyond eight lights whose attenuation is not 1 / r^2 it is taken where the middle of
// the object is. Where the scene has no light, the light of the osg::View is used (osgViewer's
// headlight). A camera sees the lights that its cull mask lets it see; those whose radius or cone
// ends before the object cost nothing.
// Output is radiance times exposure through the transfer, then osg::Fog where that is on; alpha 1.
// Tangents matter to anisotropic materials only.
#pragma once
#include <osgFbrdf/MaterialObject.h>

#include <fbrdf/plan/Transfer.h>

#include <osg/observer_ptr>
#include <osgDB/Options>
#include <osgFX/Effect>

#include <OpenThreads/Mutex>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace osgUtil {
class CullVisitor;
class GLObjectsVisitor;
}  // namespace osgUtil

namespace osgFbrdf {

constexpr unsigned int kTangentAttribute = 6;  ///< where osgFX::BumpMapping has tangents too

/// Order of the techniques of an effect.
enum TechniqueIndex { kSinglePass, kBatched, kTwoLookups, kDiffuseFallback };

/// What the last cull of an effect did.
struct DrawReport {
    std::string technique;  ///< techniqueName() of what was drawn
    std::string reason;     ///< why that is not the one selected; empty when it is
    int passes = 0;
    int lightsUsed = 0;
    int lightsDropped = 0;  ///< not valid, or too many for the fallback or for one pass
    int lightsCulled = 0;   ///< cannot reach the object
    int maxLookups = 0;     ///< in any pass
};

struct ContextNeeds;
class FileWatch;
class TechniqueChoice;
class Surfaces;

class FactorizedBrdf : public osgFX::Effect {
public:
    FactorizedBrdf();
    FactorizedBrdf(const FactorizedBrdf& other, const osg::CopyOp& op = osg::CopyOp::SHALLOW_COPY);
    META_Effect(osgFbrdf, FactorizedBrdf, "Factorized BRDF",
                "Measured reflectance as a product of small positive maps, lit by any number of "
                "lights, with as few as two texture look-ups per pass.",
                "fbrdf")

    /// Reads the file (.fbrdf, or what else osgdb_fbrdf reads) by osgDB's search paths. A file
    /// that cannot be read gives a warning with the reason and leaves the fallback; the name is
    /// kept.
    bool setMaterialFile(const std::string& file, const osgDB::Options* options = nullptr);
    const std::string& getMaterialFile() const { return materialFile_; }
    /// Reads the file again. When that fails the material stays as it is.
    bool reloadMaterial(const osgDB::Options* options = nullptr);
    /// True: the update traversal looks at the file once a second of the frame stamp, and reads it
    /// again when it changed. A file that cannot be read gives a warning, and the last good
    /// material stays.
    void setReloading(bool reloading);
    bool getReloading() const { return reloading_; }
    /// A material from memory or shared with other effects; null: the fallback. Where it has no
    /// file name, scene files hold the material itself.
    void setMaterial(MaterialObject* material);
    MaterialObject* getMaterial() const { return material_.get(); }

    void setExposure(float exposure) { exposure_ = exposure; }  ///< >= 0, times radiance
    float getExposure() const { return exposure_; }
    /// What is stored of exposure times radiance: linear (the default), or a curve, as a window
    /// without sRGB needs. A curve comes after the sum over all passes: several passes then add up
    /// in an RGBA32F surface. The fallback heeds neither.
    void setTransfer(fbrdf::Transfer transfer);
    fbrdf::Transfer getTransfer() const { return transfer_; }
    void setLightsPerPass(int lights);  ///< "batched" only, >= 1
    int getLightsPerPass() const { return lightsPerPass_; }
    void setLookupsPerPass(int lookups);  ///< limit in any pass; 0: what the technique says
    int getLookupsPerPass() const { return lookupsPerPass_; }
    void setFirstTextureUnit(int unit);  ///< the maps take this unit and those after it
    int getFirstTextureUnit() const { return firstTextureUnit_; }
    /// False: tangents are vertex attribute kTangentAttribute, and the frame is arbitrary where
    /// the model has none. True: derived per pixel, towards increasing s of texture coordinates 0.
    void setDerivedTangents(bool derived) { derivedTangents_ = derived; }
    bool getDerivedTangents() const { return derivedTangents_; }
    /// True when the colour buffer is RGBA32F: then passes add up in it. In others (a window's)
    /// they add up in an RGBA32F surface; where the target is multisampled such plans are refused,
    /// with the reason.
    void setFloatTarget(bool isFloat);
    bool getFloatTarget() const { return floatTarget_; }

    void setUpDemo() override;  ///< brushed metal, for osgfxbrowser

    DrawReport lastReport() const;
    void report(const DrawReport& report);  ///< called by the techniques
    /// Why the last context that refused a technique did so; empty: none did. Both are called by
    /// the techniques.
    std::string refusal() const;
    void refuse(const std::string& reason) const;
    /// Called by the techniques: releaseGLObjects() releases these too, as long as they are there.
    void uses(Surfaces& surfaces) const;
    /// True until arraysForgotten says that the context has drawn since releaseGLObjects; both are
    /// called by the techniques.
    bool arraysReleased(unsigned int contextId) const;
    void arraysForgotten(unsigned int contextId);

    void traverse(osg::NodeVisitor& visitor) override;
    void resizeGLObjectBuffers(unsigned int maxSize) override;
    void releaseGLObjects(osg::State* state = nullptr) const override;

protected:
    ~FactorizedBrdf() override;
    bool define_techniques() override;

private:
    void changed();
    std::vector<ContextNeeds> needs() const;
    void cull(osgUtil::CullVisitor& visitor);
    void compile(osgUtil::GLObjectsVisitor& visitor);
    bool replaceMaterial(const osg::ref_ptr<MaterialObject>& material);
    void reloadWhenChanged(const osg::NodeVisitor& visitor);
    void warnOnce(const std::string& kind, const std::string& problem);

    std::string materialFile_;
    osg::ref_ptr<MaterialObject> material_;
    float exposure_ = 1.0f;
    int lightsPerPass_ = 8, lookupsPerPass_ = 0, firstTextureUnit_ = 0;
    bool floatTarget_ = false, derivedTangents_ = false, reloading_ = false;
    fbrdf::Transfer transfer_ = fbrdf::Transfer::linear;
    std::unique_ptr<FileWatch> watch_;
    osg::ref_ptr<TechniqueChoice> choice_;
    mutable OpenThreads::Mutex reporting_;
    DrawReport report_;           ///< guarded by reporting_, as what follows
    std::set<std::string> said_;  ///< kinds that the log has, since the last change
    mutable std::vector<osg::observer_ptr<Surfaces>> surfaces_;
    mutable unsigned int releases_ = 0;
    std::map<unsigned int, unsigned int> forgotten_;  ///< releases that a context knows of
};

/// Plugin data of the options by which osgdb_fbrdf is asked for a MaterialObject. Without it a
/// material is read as a node, also where an object is asked for: osgconv 3.6 asks for objects, and
/// crashes when it gets anything but nodes and images.
constexpr const char* kReadMaterial = "osgFbrdf::MaterialObject";

/// Reads a material file through the osgdb_fbrdf plugin; null, with a warning through osg::notify
/// that names file and reason, where that fails.
osg::ref_ptr<MaterialObject> readMaterialObject(const std::string& file,
                                                const osgDB::Options* options = nullptr);

}  // namespace osgFbrdf
