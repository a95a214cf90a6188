// ModelBuild.h - what the files of the models share: rows of their parameter tables, access to
// values, and the list of all models.
#pragma once
#include <fbrdf/sources/Model.h>

#include <cmath>

namespace fbrdf {

inline ModelParameter scalarParameter(const std::string& name, double initial, double lower,
                                      double upper, const std::string& meaning)
{
    return {name, ModelParameter::Kind::scalar, initial, lower, upper, meaning, {}};
}

inline ModelParameter colourParameter(const std::string& name, double initial, double lower,
                                      double upper, const std::string& meaning)
{
    return {name, ModelParameter::Kind::colour, initial, lower, upper, meaning, {}};
}

/// A reflectance: a colour in [0, 1].
inline ModelParameter albedoParameter(const std::string& name, double initial,
                                      const std::string& meaning)
{
    return colourParameter(name, initial, 0.0, 1.0, meaning);
}

inline double scalarOf(const ModelValues& values, const char* name)
{
    return values.at(name).x;
}

inline Vec3d colourOf(const ModelValues& values, const char* name)
{
    return values.at(name);
}

/// Zenith angle of a unit direction, without acos: that loses half of the digits near the pole and
/// is NaN where rounding has left z just above 1.
inline double zenithAngle(const Vec3d& w)
{
    return std::atan2(std::hypot(w.x, w.y), w.z);
}

inline bool always(const ModelValues& /*values*/)
{
    return true;
}

inline bool never(const ModelValues& /*values*/)
{
    return false;
}

/// kd + ks <= 1 in every channel.
bool diffuseAndSpecularSumToOne(const ModelValues& values);

// One function a model, each in a file of its own; models() lists them.
Model abcModel();
Model ashikhminShirleyModel();
Model beckmannModel();
Model blinnPhongModel();
Model disneyModel();
Model ggxModel();
Model heTorranceModel();
Model lafortuneModel();
Model lambertModel();
Model orenNayarModel();
Model phongModel();
Model plasticModel();
Model poulinFournierModel();
Model rossLiModel();
Model rpvModel();
Model sgdModel();
Model wardModel();

}  // namespace fbrdf
