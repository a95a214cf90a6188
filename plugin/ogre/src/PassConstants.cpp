#include "PassConstants.h"

#include <OgreGpuProgramParams.h>

#include <glm/gtc/type_ptr.hpp>

namespace ogreFbrdf {
namespace {

void setVectors(Ogre::GpuProgramParameters& parameters, const std::string& name,
                const std::vector<fbrdf::Vec3f>& values)
{
    parameters.setNamedConstant(name, glm::value_ptr(values.front()), values.size(), 3);
}

}  // namespace

bool ObjectConstants::operator==(const ObjectConstants& other) const
{
    return lights == other.lights && rows == other.rows && shadowedLight == other.shadowedLight &&
           eye == other.eye && emitted == other.emitted;
}

ObjectConstants objectConstants(const Ogre::LightList& lights, const LightTable& table,
                                const Ogre::Pass& pass, bool hasShadows)
{
    ObjectConstants result;
    const int count = static_cast<int>(lights.size());
    const bool isListed = count < table.count() && count <= kMostListed;
    if (isListed) {
        for (const Ogre::Light* light : lights)
            if (const int row = table.rowOf(light); row >= 0)
                result.rows.push_back(static_cast<float>(row));
        result.lights = static_cast<int>(result.rows.size());
    } else {
        result.lights = table.count();
    }
    // The first light of the list is the one whose shadow maps a pass has.
    if (hasShadows && !lights.empty() && lights.front()->getCastShadows())
        result.shadowedLight = isListed ? 0 : table.rowOf(lights.front());
    result.eye = table.eye();
    const Ogre::ColourValue& emission = pass.getSelfIllumination();
    result.emitted = {emission.r, emission.g, emission.b, pass.getDiffuse().a};
    return result;
}

void setMaterialConstants(const Ogre::Pass& pass, const FbrdfResource& material,
                          const BrdfOptions& options, const PassUnits& units)
{
    Ogre::GpuProgramParameters& parameters = *pass.getFragmentProgramParameters();
    // A compiler may leave a uniform out that the text has.
    parameters.setIgnoreMissingParams(true);
    int unit = units.tables;
    for (size_t k = 0; k < material.tables().size(); ++k) {
        const TableTexture& table = material.tables()[k];
        const std::string number = std::to_string(k);
        if (table.texture) parameters.setNamedConstant("fbrdfTable" + number, unit++);
        if (!table.knots.empty()) setVectors(parameters, "fbrdfKnots" + number, table.knots);
        if (!table.encoding.ranged) continue;
        setVectors(parameters, "fbrdfLower" + number, {table.lower});
        setVectors(parameters, "fbrdfExtent" + number, {table.extent});
    }
    for (size_t t = 0; t < material.material().scales.size(); ++t)
        setVectors(parameters, "fbrdfScale" + std::to_string(t),
                   {material.material().scales[t] * options.exposure});
    parameters.setNamedConstant("fbrdfLightMap", int{units.lights});
    parameters.setNamedConstant("fbrdfLightStep", 1.0f / float{LightTable::kMostLights});
    if (!options.normalMap.empty())
        parameters.setNamedConstant("fbrdfNormalMap", int{units.normalMap});
}

void setObjectConstants(const Ogre::Pass& pass, const ObjectConstants& constants)
{
    Ogre::GpuProgramParameters& parameters = *pass.getFragmentProgramParameters();
    parameters.setNamedConstant("fbrdfLightCount", constants.lights);
    parameters.setNamedConstant("fbrdfListed", constants.rows.empty() ? 0.0f : 1.0f);
    parameters.setNamedConstant("fbrdfShadowedLight", static_cast<float>(constants.shadowedLight));
    parameters.setNamedConstant("fbrdfEye", glm::value_ptr(constants.eye), 1, 4);
    parameters.setNamedConstant("fbrdfEmitted", glm::value_ptr(constants.emitted), 1, 4);
    if (constants.rows.empty()) return;
    std::vector<float> rows = constants.rows;
    rows.resize((rows.size() + 3) / 4 * 4);
    parameters.setNamedConstant("fbrdfLightList", rows.data(), rows.size() / 4, 4);
}

}  // namespace ogreFbrdf
