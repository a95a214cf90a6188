// BrdfState.h - a material as a lighting stage of OGRE's shader generator. It stands where OGRE's
// own per-pixel lighting would, so that everything else of the generator goes on: transforms,
// skinning and instancing before it, integrated shadows, textures and fog around it.
#pragma once
#include "BrdfOptions.h"
#include "PassConstants.h"

#include <OgreShaderSubRenderState.h>

#include <map>
#include <set>

namespace ogreFbrdf {

class GlslArchiveFactory;
class LightTable;
class FbrdfResourceManager;

/// What all states of the plugin share.
struct Services {
    GlslArchiveFactory& texts;
    LightTable& lights;
    FbrdfResourceManager& materials;
    /// Programs that stay when OGRE makes its techniques anew, as it does whenever the number of
    /// lights in the view changes; their texts do not change with it.
    std::map<Ogre::String, Ogre::GpuProgramPtr> kept = {};
    /// Lines that the log has: OGRE makes techniques anew often, and each is written once.
    std::set<std::string> warned = {};
};

class BrdfState : public Ogre::RTShader::SubRenderState {
public:
    static const Ogre::String& typeName();

    explicit BrdfState(Services& services);
    ~BrdfState() override;
    const BrdfOptions& options() const { return options_; }

    const Ogre::String& getType() const override;
    int getExecutionOrder() const override;
    void copyFrom(const Ogre::RTShader::SubRenderState& other) override;
    /// False where the material cannot be drawn: OGRE's own lighting then draws the pass, with the
    /// material's albedo.
    bool preAddToRenderState(const Ogre::RTShader::RenderState* renderState, Ogre::Pass* sourcePass,
                             Ogre::Pass* pass) override;
    bool createCpuSubPrograms(Ogre::RTShader::ProgramSet* programs) override;
    void updateGpuProgramsParams(Ogre::Renderable* renderable, const Ogre::Pass* pass,
                                 const Ogre::AutoParamDataSource* source,
                                 const Ogre::LightList* lights) override;
    /// An option by its name, "material" among them. False where it is refused; the log says why.
    bool setParameter(const Ogre::String& name, const Ogre::String& value) override;

private:
    std::string whyNot(const Ogre::Pass& pass) const;
    void drawDiffuse(Ogre::Pass& pass) const;
    void addTextures(Ogre::Pass& pass);
    std::string fragmentText() const;
    void addVertexStage(Ogre::RTShader::Function& vertex, Ogre::RTShader::Function& fragment,
                        Ogre::RTShader::Program& program);
    void addFragmentStages(Ogre::RTShader::Function& fragment);
    bool needsTangents() const;

    Services& services_;
    BrdfOptions options_;
    FbrdfResourcePtr material_;
    PassUnits units_;
    Ogre::RTShader::ParameterPtr position_, normal_, tangent_, coordinate_;  ///< in the fragment
    bool areMaterialConstantsSet_ = false;
    ObjectConstants last_;
};

}  // namespace ogreFbrdf
