// Material.h - a fitted BRDF: a form, its tables as stored, a colour scale for each term; and its
// evaluation.
#pragma once
#include <fbrdf/brdf/Form.h>
#include <fbrdf/brdf/LobeTable.h>
#include <fbrdf/brdf/Table.h>

#include <map>
#include <string>
#include <vector>

namespace fbrdf {

struct Material {
    Form form;
    std::vector<Table> tables;  ///< one for each form.tables, same order
    std::vector<Vec3f> scales;  ///< one for each term, >= 0
    std::string name;
    /// Further entries of the file: "source", "generator", "units" ("1/sr"), "colorspace"
    /// ("lin_rec709"), ...
    std::map<std::string, std::string> notes;
    /// Errors of the fit by the names that docs/method.md, section Errors, defines.
    std::map<std::string, double> errors;
    /// How it reflects environments; empty where nobody has fitted that (LobeFit.h).
    LobeTable lobes = {};
};

/// Bytes of all tables: texels x channels x bytes a channel.
size_t materialBytes(const Material& material);

/// True when a table may hold negative values: terms, and sums of some of them, may be negative.
bool hasSigns(const Material& material);

/// Throws Error(input) naming `where` unless form, tables and scales agree and every number is
/// finite.
void validate(const Material& material, const std::string& where);

/// f(wo, wi) in 1/sr; 0 when either direction is at or below the horizon. T = float follows the
/// shader step by step, T = double is exact. Directions are unit, in the local frame. Expects a
/// material that validate accepts.
template <class T>
Vec3<T> evaluate(const Material& material, const Vec3<T>& wo, const Vec3<T>& wi);

/// The albedo of a diffuse surface that stands for the material where that cannot be drawn: the
/// share of even light that it reflects to a view at 45 degrees, in [0, 1]; within a few percent
/// for all but mirrors. Expects a material that validate accepts.
Vec3f diffuseAlbedo(const Material& material);

}  // namespace fbrdf
