// Program.h - linked programs, found by their text: materials of one form and one set of sizes
// share them.
#pragma once
#include "CompiledHooks.h"
#include "MaterialUniforms.h"
#include "Objects.h"

#include <fbrdf/shaders/ShaderSource.h>

#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <unordered_map>
#include <vector>

namespace fbrdf::gl {

/// Locations are -1 where a program has no such uniform.
struct Program {
    Object object;
    GLint modelView = -1, projection = -1, eye = -1;
    GLint lights = -1, lightCount = -1, lightNumbers = -1, readScale = -1, gain = -1;
    int readUnit = -1;  ///< texture unit (from the device's first) of the surface that is read
    int normalMapUnit = -1;
    struct ClusterUniforms {
        int lightsUnit = -1, indicesUnit = -1, listsUnit = -1, numbersUnit = -1;
        GLint grid = -1, scale = -1;
    } clusters;
    int instancesUnit = -1, parametersUnit = -1;  ///< of a packed material
    MaterialUniforms material;
    std::vector<int> tableUnits;  ///< of each table of the form, as readUnit
    size_t extraArrays = 0;       ///< of a mesh that the vertex hook reads
    LookupCount lookups;          ///< counted from what the linker left active
};

class ProgramCache {
public:
    explicit ProgramCache(DevicePtr device) : device_(std::move(device)) {}

    /// Builds at first use. Throws Error(gl) with the compiler's log, the first time and every time
    /// after (without compiling again).
    const Program& find(const MaterialResources& material, const ProgramSpec& spec,
                        const SurfaceOptions& surface);

    /// Throws Error(input) for hooks that do not compile.
    void check(const Hooks& hooks);

private:
    struct Text {
        std::string vertex, fragment;
        bool operator<(const Text& other) const
        {
            return std::tie(fragment, vertex) < std::tie(other.fragment, other.vertex);
        }
    };
    struct Entry {
        std::unique_ptr<Program> program;
        std::string failure;
    };
    Entry& entryOf(const MaterialResources& material, const ProgramSpec& spec,
                   const SurfaceOptions& surface);
    std::unique_ptr<Program> build(const MaterialResources& material, const Text& text);
    Object linked(const Text& text, const MaterialResources& material);
    const Object& vertexShader(const std::string& text);

    DevicePtr device_;
    std::map<std::string, Object> vertexShaders_;  ///< by text
    std::map<Text, Entry> entries_;
    /// By material, specification and surface.
    std::unordered_map<std::string, Entry*> shortcut_;
};

}  // namespace fbrdf::gl
