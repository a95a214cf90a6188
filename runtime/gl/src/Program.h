// Program.h - a linked program and where it wants its uniforms.
#pragma once
#include "MaterialUniforms.h"
#include "Objects.h"

#include <fbrdf/shaders/ShaderSource.h>

#include <string>
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
    } clusters, areas;                            ///< lists of lights, and of area lights
    int instancesUnit = -1, parametersUnit = -1;  ///< of a packed material
    MaterialUniforms material;
    std::vector<int> tableUnits;  ///< of each table of the form, as readUnit
    size_t extraArrays = 0;       ///< of a mesh that the vertex hook reads
    struct LobeUniforms {
        int mapUnit = -1, rowsUnit = -1;  ///< rows of a packed material
        GLint toEnvironment = -1, scale = -1, rows = -1, bend = -1;
        GLint areaLights = -1, areaLightCount = -1;
        GLint lattice = -1;  ///< of directions that are drawn
    } lobes;
    LookupCount lookups;  ///< counted from what the linker left active
};

/// Throws Error(gl) with the compiler's log.
Object compiledShader(const DevicePtr& device, GLenum stage, const std::string& source);

/// The attributes are where meshes have them (Attribute). The shaders may be deleted then. Throws
/// Error(gl) with the linker's log.
Object linkedShaders(const DevicePtr& device, const Object& vertexShader,
                     const Object& fragmentShader, const std::string& name);

/// A program of one compute shader. Throws Error(gl) with the compiler's or the linker's log.
Object linkedCompute(const DevicePtr& device, const std::string& source, const std::string& name);

/// Compiles the fragment shader, links it with `vertexShader`, which may be deleted then, and finds
/// the uniforms. Leaves the program current. Throws Error(gl) with the compiler's or the linker's
/// log.
Program linkedProgram(const DevicePtr& device, const MaterialResources& material,
                      const Object& vertexShader, const std::string& fragment);

}  // namespace fbrdf::gl
