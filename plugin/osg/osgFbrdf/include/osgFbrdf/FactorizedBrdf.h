// FactorizedBrdf.h - the effect: everything below it is drawn with one factored material, lit by
// every osgFbrdf::PointLights and every osg::LightSource of the scene, and by its
// osgFbrdf::EnvironmentLight.
//
// The techniques are, best first, those of fbrdf::allTechniques() ("single pass", "batched", "two
// look-ups per pass"), then "diffuse fallback". Each needs less than the one before, so what one
// context can draw a better one can draw too; every context is asked when it first draws, and the
// best technique that all can draw is taken. selectTechnique() forces one. Cameras of shadow maps,
// which draw no colour or override materials, draw the children as they are. Plans and shaders are
// the runtime's (fbrdf/plan, fbrdf/shaders).
//
// An osg::Light lights the effect as it lights a white Lambertian in fixed function: by its diffuse
// colour, attenuation, cut-off and exponent, and not while a state set above turns its mode
// GL_LIGHTn off. After the first eight lights whose attenuation is not 1 / r^2, a light is
// everywhere as bright as it should be in the middle of the object. Where the scene has neither
// light nor environment, the light of the osg::View is used (osgViewer's headlight). A camera sees
// the lights that its cull mask lets it see. Lights whose radius or cone ends before the object
// cost nothing.
//
// Parts of the model may have effects of their own, by name: see setPart().
//
// What is drawn is radiance times exposure through the transfer, then osg::Fog where that is on;
// alpha is 1. Tangents matter to anisotropic materials only.
#pragma once
#include <osgFbrdf/MaterialObject.h>
#include <osgFbrdf/ModelTextures.h>
#include <osgFbrdf/VertexHook.h>

#include <fbrdf/plan/Plan.h>
#include <fbrdf/plan/Technique.h>
#include <fbrdf/plan/Transfer.h>

#include <osgDB/Options>
#include <osgFX/Effect>

#include <array>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace osgUtil {
class CullVisitor;
class GLObjectsVisitor;
}  // namespace osgUtil

namespace osgFbrdf {

/// The vertex attribute that has tangents; osgFX::BumpMapping has them there too.
constexpr unsigned int kTangentAttribute = 6;

/// The techniques of an effect in their order, as selectTechnique() takes them.
enum TechniqueIndex {
    kSinglePass,
    kBatched,
    kTwoLookups,
    kDiffuseFallback = fbrdf::kTechniqueCount,  ///< after all techniques of the runtime
};

/// Formats that setAccumulation() takes.
constexpr std::array<fbrdf::ColourFormat, 3> kAccumulationFormats{
    fbrdf::ColourFormat::rgba32f, fbrdf::ColourFormat::rgba16f, fbrdf::ColourFormat::rgba8};

/// What the last cull of an effect did.
struct DrawReport {
    /// techniqueName() of what was drawn; "nothing" in a core profile without OSG's inputs.
    std::string technique;
    std::string reason;  ///< why that is not the one selected; empty when it is
    int passes = 0;
    int lightsUsed = 0;     ///< area lights included, as in what follows
    int lightsDropped = 0;  ///< lights that are not valid, or too many for what was drawn
    int lightsCulled = 0;   ///< lights that cannot reach the object
    int maxLookups = 0;     ///< the most texture look-ups of any pass
    /// Why the environment or the area lights of the scene do not light it; empty where they do, or
    /// there are none.
    std::string whyNoEnvironment = {};
    int environmentsLeftOut = 0;  ///< all but the first
    std::string whyOpaque = {};   ///< why what is blended in the model is not; empty where it is
    /// What is wrong with the last area light that is not valid; empty where all are.
    std::string whyLightsInvalid = {};
    /// The most lights that any part of the picture has, where lights come from lists; else 0.
    int longestLightList = 0;
    int shadowMaps = 0;  ///< maps of osgShadow in which passes look for shadows
    /// Why shadows of the scene do not fall on the effect; empty where they do, or there are none.
    std::string whyNoShadows = {};
    std::string accumulation = {};  ///< format in which the lights added up, "RGBA32F"
};

struct ContextNeeds;
class EffectInternals;
class FactorizedBrdf;
class FileWatch;

/// A part of a model and the effect that draws it.
struct ModelPart {
    std::string name;
    osg::ref_ptr<FactorizedBrdf> effect;  ///< never null; its own children are not drawn
};

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
    /// True: the update traversal looks at the file, and those of parts, once a second of the frame
    /// stamp, and reads what changed again. A file that cannot be read gives a warning, and the
    /// last good material stays.
    void setReloading(bool reloading);
    bool getReloading() const { return reloading_; }
    /// A material from memory or shared with other effects; null: the fallback. Where it has no
    /// file name, scene files contain the material itself. options: where to look for the file that
    /// setReloading() watches.
    void setMaterial(MaterialObject* material, const osgDB::Options* options = nullptr);
    MaterialObject* getMaterial() const { return material_.get(); }

    /// The model below this effect is drawn part by part, in one traversal a pass: what is below a
    /// node whose osg::Material, state set or own name is `name`, the first of them that a part
    /// has, by the material and the properties of `effect`, of which several parts may share one;
    /// the innermost part counts. What is in no part is drawn by this effect where that has a
    /// material or the name of a file, and as the model says where not. Null: there is no such
    /// part. A property that is set here later is set for the effects of parts too, and a technique
    /// that is selected here is that of all that select none.
    void setPart(const std::string& name, FactorizedBrdf* effect);
    /// The same with a material, or the file of one, and the properties that this effect has now.
    /// Parts of one material share one effect. A file that cannot be read gives a warning with the
    /// reason, and leaves the part the fallback.
    void setPartMaterial(const std::string& name, MaterialObject* material);
    bool setPartMaterialFile(const std::string& name, const std::string& file,
                             const osgDB::Options* options = nullptr);
    const std::vector<ModelPart>& getParts() const { return parts_; }
    /// The effects of the parts, each once.
    std::vector<FactorizedBrdf*> effectsOfParts() const;

    /// Radiance is multiplied by it; >= 0.
    void setExposure(float exposure);
    float getExposure() const { return exposure_; }
    /// What is stored of exposure times radiance: linear (the default), or a curve, as a window
    /// without sRGB needs. A curve comes after the sum over all passes: several passes then add up
    /// in an RGBA32F surface. The fallback ignores the transfer.
    void setTransfer(fbrdf::Transfer transfer);
    fbrdf::Transfer getTransfer() const { return transfer_; }
    /// Lights in each pass of the technique "batched"; >= 1.
    void setLightsPerPass(int lights);
    int getLightsPerPass() const { return lightsPerPass_; }
    /// The most texture look-ups that any pass may have; 0: the limit of the technique.
    void setLookupsPerPass(int lookups);
    int getLookupsPerPass() const { return lookupsPerPass_; }
    /// The maps take this texture unit and those after it.
    void setFirstTextureUnit(int unit);
    int getFirstTextureUnit() const { return firstTextureUnit_; }
    /// Units that no texture of the effect takes, as others have theirs there.
    void setFreeTextureUnits(const std::set<int>& units);
    const std::set<int>& getFreeTextureUnits() const { return freeTextureUnits_; }
    /// False: tangents are vertex attribute kTangentAttribute, and the frame is arbitrary where
    /// the model has none. True: derived per pixel, towards increasing s of texture coordinates 0.
    void setDerivedTangents(bool derived);
    bool getDerivedTangents() const { return derivedTangents_; }
    /// True: maps are filtered in the shader, 4 fetches for each look-up (8 in a volume), where a
    /// GPU's own filter, which may know as few as 256 places between two texels, is too coarse.
    void setPreciseFiltering(bool precise);
    bool getPreciseFiltering() const { return preciseFiltering_; }
    /// True when the colour buffer is RGBA32F: then passes add up in it. In others (a window's)
    /// they add up in a surface.
    void setFloatTarget(bool isFloat);
    bool getFloatTarget() const { return floatTarget_; }
    /// The format of surfaces in which passes add up: rgba32f (the default); rgba16f, half as
    /// large; rgba8, a quarter, in which sums are scaled so that none exceeds 1. A finer one is
    /// taken where the error of a sum would be more than an eighth, or has no bound; a coarser one
    /// where the context has no other. Other formats count as rgba32f.
    void setAccumulation(fbrdf::ColourFormat format);
    fbrdf::ColourFormat getAccumulation() const { return accumulation_; }

    /// Textures of the model that the effect uses, by their units; none unless they are named.
    /// Where the model then has an alpha its alpha test is kept in all passes, and what is blended,
    /// as GL_BLEND is on below the effect, is blended over what is behind it: in one pass, in the
    /// bin and the order that the model asks for, without fog.
    void setModelTextures(const ModelTextures& textures);
    const ModelTextures& getModelTextures() const { return textures_; }
    /// Vertex code of all passes.
    void setVertexHook(const VertexHook& hook);
    const VertexHook& getVertexHook() const { return vertexHook_; }

    /// Sets a brushed metal, for osgfxbrowser.
    void setUpDemo() override;

    DrawReport lastReport() const;

    void traverse(osg::NodeVisitor& visitor) override;
    void resizeGLObjectBuffers(unsigned int maxSize) override;
    void releaseGLObjects(osg::State* state = nullptr) const override;

protected:
    ~FactorizedBrdf() override;
    bool define_techniques() override;

private:
    void changed();
    void takeProperties(const FactorizedBrdf& other);
    template <class Value>
    void setOfParts(void (FactorizedBrdf::*set)(Value), Value value);
    std::vector<ContextNeeds> needs() const;
    void cull(osgUtil::CullVisitor& visitor);
    /// Culls the model, which may be that of another effect, with the material of this one.
    void cullAs(osgUtil::CullVisitor& visitor, const FactorizedBrdf& model,
                const std::function<void()>& cullModel,
                const std::function<void()>& cullBlended = nullptr);
    void cullParts(osgUtil::CullVisitor& visitor);
    void shareEffectOf(ModelPart& part);
    void warnOfNamesWithoutPart();
    void compile(osgUtil::GLObjectsVisitor& visitor);
    bool replaceMaterial(const osg::ref_ptr<MaterialObject>& material);
    void reloadWhenChanged(const osg::NodeVisitor& visitor);

    std::vector<ModelPart> parts_;
    ModelTextures textures_;
    VertexHook vertexHook_;
    std::string materialFile_;
    osg::ref_ptr<MaterialObject> material_;
    float exposure_ = 1.0f;
    int lightsPerPass_ = 8, lookupsPerPass_ = 0, firstTextureUnit_ = 0;
    std::set<int> freeTextureUnits_;
    bool floatTarget_ = false, derivedTangents_ = false, preciseFiltering_ = false,
         reloading_ = false;
    fbrdf::Transfer transfer_ = fbrdf::Transfer::linear;
    fbrdf::ColourFormat accumulation_ = fbrdf::ColourFormat::rgba32f;
    std::unique_ptr<FileWatch> watch_;
    osg::ref_ptr<EffectInternals> internals_;
};

/// Plugin data of the options by which osgdb_fbrdf is asked for a MaterialObject. Without it a
/// material is read as a node, also where an object is asked for: osgconv 3.6 asks for objects, and
/// crashes when it gets anything but nodes and images.
constexpr const char* kReadMaterial = "osgFbrdf::MaterialObject";
/// Values of that data. kShared: the object that was made of the same file where one is still in
/// use; kAnew: another object.
constexpr const char *kShared = "shared", *kAnew = "anew";

/// Reads a material file through the osgdb_fbrdf plugin; null, with a warning through osg::notify
/// that names file and reason, where that fails. As long as one is in use, the same file gives the
/// same object.
osg::ref_ptr<MaterialObject> readMaterialObject(const std::string& file,
                                                const osgDB::Options* options = nullptr);

}  // namespace osgFbrdf
