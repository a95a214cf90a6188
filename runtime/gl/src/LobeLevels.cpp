#include "LobeLevels.h"

#include "TextureUpload.h"

#include <fbrdf/shaders/PrefilterSource.h>

#include <algorithm>

namespace fbrdf::gl {
namespace {

/// The cells of a lobe as a row of texels: see PrefilterSource.h.
std::vector<glm::vec4> cellTexels(const std::vector<LobeCell>& cells, int sourceSize)
{
    std::vector<glm::vec4> texels(kMostCells, glm::vec4(0.0f));
    for (size_t i = 0; i < cells.size(); ++i)
        texels[i] =
            glm::vec4(cells[i].direction.x, cells[i].direction.y, cells[i].weight,
                      levelOfCell(double(cells[i].solidAngle), {0.0, 0.0, 1.0}, sourceSize));
    return texels;
}

}  // namespace

LobeLevels::LobeLevels(DevicePtr device, StateGuard& state, Object source,
                       const EnvironmentFormat& format)
    : device_(std::move(device)),
      triangle_(device_, coveringTriangle()),
      source_(std::move(source)),
      format_(format),
      level_(format.levels() - 1)
{
    const MeshBinding binding(triangle_);
    const CubePainter painter(device_, state, triangle_);
    program_ =
        painter.programOf(prefilterLobeFragment(device_->capabilities.glsl), "environment lobe");
    painter.setSampler(program_, "fbrdfRadiance", 0);
    painter.setSampler(program_, "fbrdfCells", 1);
    device_->gl.Uniform1f(device_->gl.GetUniformLocation(program_.name(), "fbrdfCellRoom"),
                          static_cast<GLfloat>(kMostCells));
}

/// The program must be current.
void LobeLevels::bindCells(StateGuard& state)
{
    const Functions& gl = device_->gl;
    const bool isNew = !cells_;
    if (isNew) cells_ = createObject(device_, ObjectKind::texture);
    state.bindTexture(1, GL_TEXTURE_2D, cells_.name());
    if (!isNew) return;
    const auto cells = lobeCells(kLobeLevels - format_.levels() + level_);
    setSampling(gl, GL_TEXTURE_2D, false);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kMostCells, 1, 0, GL_RGBA, GL_FLOAT,
                  cellTexels(cells, format_.size).data());
    gl.Uniform1i(gl.GetUniformLocation(program_.name(), "fbrdfCellCount"),
                 static_cast<GLint>(cells.size()));
}

/// Returns how many rows were drawn, of one level.
int LobeLevels::drawRows(StateGuard& state, GLuint cube, int rows)
{
    const Functions& gl = device_->gl;
    const MeshBinding binding(triangle_);
    CubePainter painter(device_, state, triangle_);
    gl.UseProgram(program_.name());
    state.bindTexture(0, GL_TEXTURE_CUBE_MAP, source_.name());
    state.filterAcrossEdges();
    bindCells(state);
    const int count = std::min(rows, size() - row_);
    painter.draw(program_, cube, {level_, size(), row_, count}, format_.largest());
    row_ += count;
    if (row_ < size()) return count;
    state.bindTexture(0, GL_TEXTURE_CUBE_MAP, cube);
    gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_LOD, level_);
    --level_;
    row_ = 0;
    cells_.reset();
    return count;
}

void LobeLevels::draw(StateGuard& state, GLuint cube, long long texels)
{
    while (texels > 0 && !isFinished()) {
        const long long inRow = 6LL * size();
        const long long rows = (texels + inRow - 1) / inRow;
        texels -= inRow *
                  drawRows(state, cube, static_cast<int>(std::min<long long>(rows, format_.size)));
    }
}

void LobeLevels::drawUpTo(StateGuard& state, GLuint cube, int size)
{
    while (!isFinished() && this->size() <= size) drawRows(state, cube, this->size());
}

}  // namespace fbrdf::gl
