// DiffuseTechnique.h - the fallback, which draws wherever OSG draws: by fixed function, or a
// program in its place (DiffuseShader.h), with a diffuse colour as bright as the material, under
// the brightest lights. An environment is as bright from all sides there as it is on average.
#pragma once
#include "EffectCull.h"

#include <string>

namespace osgFbrdf {

/// Culls the model diffusely and reports why; or does not, where nothing can be drawn, and reports
/// that.
void cullDiffuse(const EffectCull& cull, const std::string& reason);

class DiffuseTechnique : public EffectTechnique {
public:
    const char* techniqueName() override { return "diffuse fallback"; }
    const char* techniqueDescription() override { return "Diffuse, eight lights at most."; }
    bool validate(osg::State&) const override { return true; }
    void cull(const EffectCull& cull) override;

protected:
    ~DiffuseTechnique() override = default;
};

}  // namespace osgFbrdf
