#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/scene/ViewTechnique.h>

#include <array>

namespace fbrdf::scene {
namespace {

struct CpuTechnique {
    const char *name, *description;
};
/// Those of ViewTechnique from kTechniqueCount on, in its order.
constexpr std::array<CpuTechnique, kViewTechniqueCount - kTechniqueCount> kCpuTechniques{{
    {"vertex", "true BRDF at the vertices"},
    {"reference", "true BRDF at every pixel, in double"},
    {"path", "the same with shadows and interreflection, path-traced"},
}};

const CpuTechnique& cpuTechnique(ViewTechnique technique)
{
    return kCpuTechniques[static_cast<size_t>(technique) - kTechniques.size()];
}

}  // namespace

const char* viewTechniqueName(ViewTechnique technique)
{
    return isOnCpu(technique) ? cpuTechnique(technique).name
                              : techniqueName(runtimeTechnique(technique));
}

ViewTechnique viewTechniqueFromName(const std::string& name)
{
    std::string all;
    for (int i = 0; i < kViewTechniqueCount; ++i) {
        const auto technique = static_cast<ViewTechnique>(i);
        if (name == viewTechniqueName(technique)) return technique;
        all += (i == 0 ? "" : ", ") + std::string(viewTechniqueName(technique));
    }
    throw Error(ErrorKind::usage, "--technique", Found("'" + name + "'").expected("one of " + all));
}

std::string viewTechniqueHelp()
{
    std::string onCpu;
    for (const CpuTechnique& t : kCpuTechniques)
        onCpu += std::string(onCpu.empty() ? "" : ", ") + t.name + " (" + t.description + ")";
    return techniqueNames() + "; on the CPU: " + onCpu;
}

bool isOnCpu(ViewTechnique technique)
{
    return static_cast<int>(technique) >= kTechniqueCount;
}

Technique runtimeTechnique(ViewTechnique technique)
{
    return isOnCpu(technique) ? Technique::single : static_cast<Technique>(technique);
}

}  // namespace fbrdf::scene
