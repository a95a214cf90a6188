// CubePainter.h - draws the faces of the levels of a cube map.
#pragma once
#include "MeshResources.h"
#include "StateGuard.h"

namespace fbrdf::gl {

/// One triangle that covers all of a target.
MeshData coveringTriangle();

/// Rows of a level of a cube map, of all faces.
struct CubeRows {
    int level, size;  ///< size: texels on a side of a face of the level
    int first, count;
};

class CubePainter {
public:
    /// triangle: bound by the caller. Sets up blending and depth.
    CubePainter(const DevicePtr& device, StateGuard& state, const MeshResources& triangle);

    /// Builds a program for the covering triangle and leaves it current. Throws Error(gl).
    Object programOf(const std::string& fragment, const std::string& name) const;
    /// unit: from the device's first. The program must be current.
    void setSampler(const Object& program, const char* name, int unit) const;
    /// Draws rows with the current program (PrefilterSource.h). Throws Error(gl) where they cannot
    /// be drawn to.
    void draw(const Object& program, GLuint cube, const CubeRows& rows, float largest);

private:
    DevicePtr device_;
    StateGuard& state_;
    const MeshResources& triangle_;
    Object framebuffer_;
};

}  // namespace fbrdf::gl
