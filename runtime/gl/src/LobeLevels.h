// LobeLevels.h - draws the levels of a prefiltered cube map, those of wide lobes first, at once or
// some rows at a time.
#pragma once
#include "CubePainter.h"
#include "EnvironmentFormat.h"

namespace fbrdf::gl {

/// What the drawing goes on with: the cube that is convolved, the program, and the next rows.
/// Until all levels are drawn a cube map is looked up at none finer than those that are.
class LobeLevels {
public:
    /// source: a cube of floats with all levels. Throws Error(gl).
    LobeLevels(DevicePtr device, StateGuard& state, Object source, const EnvironmentFormat& format);

    /// Draws rows of all faces until they have `texels` texels or all levels are drawn. Throws
    /// Error(gl).
    void draw(StateGuard& state, GLuint cube, long long texels);
    /// Draws all levels whose faces have at most so many texels on a side.
    void drawUpTo(StateGuard& state, GLuint cube, int size);
    bool isFinished() const { return level_ < 0; }
    GLuint source() const { return source_.name(); }
    Object takeSource() { return std::move(source_); }

private:
    int size() const { return format_.size >> level_; }
    int drawRows(StateGuard& state, GLuint cube, int rows);
    void bindCells(StateGuard& state);

    DevicePtr device_;
    MeshResources triangle_;
    Object source_, program_, cells_;  ///< cells_: of the level that is being drawn
    EnvironmentFormat format_;
    int level_, row_ = 0;  ///< what is drawn next; level -1: nothing is left
};

}  // namespace fbrdf::gl
