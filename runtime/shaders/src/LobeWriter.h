// LobeWriter.h - writes the lobes of a pass as GLSL.
#pragma once
#include "FragmentWriter.h"

namespace fbrdf {

inline bool hasLobes(const FragmentContext& c)
{
    return !c.spec.lobes.isEmpty();
}
inline bool hasAreaLights(const FragmentContext& c)
{
    return hasLobes(c) && c.spec.lobes.areaSlots > 0;
}
/// True where lobes are about bent normals, which have a tangent frame.
inline bool hasBentLobes(const FragmentContext& c)
{
    return hasLobes(c) && c.spec.lobes.table.axes == LobeAxes::bent;
}

std::string lobeUniforms(const FragmentContext& c);
/// Statements that add the lobes to `total`; they expect what surfaceLines declares.
std::string lobeLines(const FragmentContext& c);

}  // namespace fbrdf
