// DiffuseTechnique.h - the fallback: fixed function, a diffuse colour as bright as the material,
// the brightest lights. Draws wherever OSG draws.
#pragma once
#include <osgFbrdf/FactorizedBrdf.h>

#include <osgFX/Technique>

namespace osgUtil {
class CullVisitor;
}

namespace osgFbrdf {

/// Culls the children of the effect diffusely and reports why.
void cullDiffuse(osgUtil::CullVisitor& visitor, FactorizedBrdf& effect, const std::string& reason);

class DiffuseTechnique : public osgFX::Technique {
public:
    explicit DiffuseTechnique(FactorizedBrdf& effect) : effect_(effect) {}

    const char* techniqueName() override { return "diffuse fallback"; }
    const char* techniqueDescription() override
    {
        return "Fixed function: diffuse, eight lights at most.";
    }
    bool validate(osg::State&) const override { return true; }
    void traverse(osg::NodeVisitor& visitor, osgFX::Effect* effect) override;

protected:
    ~DiffuseTechnique() override = default;
    void define_passes() override {}

private:
    FactorizedBrdf& effect_;  ///< owns this
};

}  // namespace osgFbrdf
