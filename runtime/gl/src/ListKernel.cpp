#include "ListKernel.h"

#include "Program.h"
#include "StorageGuard.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <algorithm>

namespace fbrdf::gl {
namespace {

/// What the context itself rules out.
std::string whyImpossible(const Capabilities& has)
{
    if (has.computeBuffers == 0)
        return Found("OpenGL " + std::to_string(has.glMajor) + "." + std::to_string(has.glMinor) +
                     " without compute shaders")
            .expected("them, which come with 4.3");
    if (has.computeBuffers < kListBuffers)
        return Found(std::to_string(has.computeBuffers) + " storage buffers of a compute shader")
            .expected("at least " + std::to_string(kListBuffers));
    return "";
}

// Draws fetch what the shader has written, the next upload overwrites it, and so does the next
// dispatch.
constexpr GLbitfield kBarriers =
    GL_TEXTURE_FETCH_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT;

}  // namespace

const std::string& ListKernel::whyNot()
{
    if (isBuilt_) return whyNot_;
    isBuilt_ = true;
    whyNot_ = whyImpossible(device_->capabilities);
    if (!whyNot_.empty()) return whyNot_;
    try {
        build();
    } catch (const Error& error) {
        whyNot_ = error.what();
    }
    return whyNot_;
}

void ListKernel::build()
{
    program_ = linkedCompute(device_, clusterListsSource(), "lists of lights");
    const auto location = [&](const char* name) {
        return device_->gl.GetUniformLocation(program_.name(), name);
    };
    grid_ = location("fbrdfClusterGrid");
    listed_ = location("fbrdfListed");
    margin_ = location("fbrdfTileMargin");
}

std::string ListKernel::whyTooMany(const ClusterWork& work) const
{
    const Capabilities& has = device_->capabilities;
    const auto most = static_cast<size_t>(std::min<long long>(
        has.maxBufferTexels, has.maxStorageBytes / static_cast<long long>(sizeof(int32_t))));
    const size_t vectors = std::min(static_cast<size_t>(has.maxBufferTexels),
                                    static_cast<size_t>(has.maxStorageBytes) / sizeof(glm::vec4));
    if (work.vectors.size() > vectors)
        return Found(std::to_string(work.vectors.size()) + " vectors of lights")
            .expected("at most " + std::to_string(vectors) + " in a storage buffer");
    if (work.mostEntries > most)
        return Found("lists of up to " + std::to_string(work.mostEntries) + " entries")
            .expected("at most " + std::to_string(most) + " in a storage buffer");
    return "";
}

void ListKernel::make(const LightClusters& clusters, const ClusterWork& work,
                      ClusterBuffers& buffers)
{
    FBRDF_ASSERT(whyNot(), ==, "");
    const Functions& gl = device_->gl;
    const StorageGuard guard(*device_, kListBuffers);
    // Before the uploads too: the last draws may still read what they replace.
    gl.MemoryBarrier(kBarriers);
    const auto lights = static_cast<int>(clusters.lights.size());
    buffers.reserveLists(clusters, work, lights - clusters.everywhere);
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffers.work.buffer());
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, buffers.lists.buffer());
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, buffers.indices.buffer());
    const ClusterGrid& grid = clusters.grid;
    gl.UseProgram(program_.name());
    gl.Uniform3i(grid_, grid.columns, grid.rows, grid.slices);
    gl.Uniform3i(listed_, clusters.everywhere, lights, static_cast<GLint>(work.mostEntries));
    gl.Uniform1f(margin_, work.tileMargin);
    const auto groups =
        static_cast<GLuint>((grid.columns + kClustersPerGroup - 1) / kClustersPerGroup);
    gl.DispatchCompute(groups, static_cast<GLuint>(grid.rows), static_cast<GLuint>(grid.slices));
    gl.MemoryBarrier(kBarriers);
}

}  // namespace fbrdf::gl
