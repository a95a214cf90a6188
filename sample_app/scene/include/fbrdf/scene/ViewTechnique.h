// ViewTechnique.h - the ways to a picture of a scene, by their names.
#pragma once
#include <fbrdf/plan/Technique.h>

#include <string>

namespace fbrdf::scene {

/// How a picture is made: by a technique of the runtime (fbrdf/plan/Technique.h), which keeps its
/// number, or by one that the CPU draws (CpuRenderer.h, fbrdf/truth/PathTracer.h).
enum class ViewTechnique { vertex = kTechniqueCount, reference, path };
constexpr int kViewTechniqueCount = kTechniqueCount + 3;
constexpr ViewTechnique viewTechnique(Technique technique)
{
    return static_cast<ViewTechnique>(technique);
}

const char* viewTechniqueName(ViewTechnique technique);        ///< "two-lookup", ...
ViewTechnique viewTechniqueFromName(const std::string& name);  ///< throws Error(usage)
std::string viewTechniqueHelp();  ///< names, with what those on the CPU draw
bool isOnCpu(ViewTechnique technique);
Technique runtimeTechnique(ViewTechnique technique);  ///< expects !isOnCpu(technique)

}  // namespace fbrdf::scene
