// Program.h - linked programs, found by their text: materials of one form and one set of sizes
// share them.
#pragma once
#include "MaterialUniforms.h"
#include "Objects.h"

#include <fbrdf/shaders/ShaderSource.h>

#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace fbrdf::gl {

/// Locations are -1 where a program has no such uniform.
struct Program {
    Object object;
    GLint modelView = -1, projection = -1, eye = -1;
    GLint lights = -1, lightCount = -1, readScale = -1;
    int readUnit = -1;  ///< texture unit (from the device's first) of the surface that is read
    struct ClusterUniforms {
        int lightsUnit = -1, indicesUnit = -1, listsUnit = -1;
        GLint grid = -1, scale = -1;
    } clusters;
    int instancesUnit = -1, parametersUnit = -1;  ///< of a packed material
    MaterialUniforms material;
    std::vector<int> tableUnits;  ///< of each table of the form, as readUnit
    LookupCount lookups;          ///< counted from what the linker left active
};

class ProgramCache {
public:
    explicit ProgramCache(DevicePtr device) : device_(std::move(device)) {}

    /// Builds at first use. Throws Error(gl) with the compiler's log, the first time and every time
    /// after (without compiling again).
    const Program& find(const GpuMaterial& material, const ProgramSpec& spec);

private:
    struct Entry {
        std::unique_ptr<Program> program;
        std::string failure;
    };
    std::unique_ptr<Program> build(const GpuMaterial& material, const std::string& fragment);
    Object linked(const std::string& fragment, const GpuMaterial& material);
    const Object& vertexShader(bool instanced);

    DevicePtr device_;
    Object vertexShaders_[2];  ///< the second for instances
    Entry& entryOf(const GpuMaterial& material, const ProgramSpec& spec);
    std::map<std::string, Entry> entries_;              ///< by fragment source
    std::unordered_map<std::string, Entry*> shortcut_;  ///< by material and specification
};

}  // namespace fbrdf::gl
