// ClusterBuffers.h - lights or area lights, and their lists, as buffer textures; needs OpenGL 3.1.
#pragma once
#include "BufferTexture.h"

#include <fbrdf/plan/AreaVectors.h>
#include <fbrdf/plan/LightClusters.h>

namespace fbrdf::gl {

struct ClusterBuffers {
    explicit ClusterBuffers(const DevicePtr& device)
        : lights(device, GL_RGBA32F, "lights"),
          indices(device, GL_R32I, "light indices"),
          lists(device, GL_RG32I, "light lists"),
          numbers(device, GL_R32I, "light numbers"),
          work(device, GL_RGBA32F, "reaches of lights")
    {
    }

    /// Uploads the lights. lightNumbers: for each light that the clusters were made from, its place
    /// among the lights of the draw. isNew: false where the clusters are those of the last call.
    /// Returns whether the lists have to be uploaded or made too. Leaves the array buffer bound.
    /// Throws Error(gl) where a buffer texture is too small.
    bool updateLights(const LightClusters& clusters, const std::vector<int32_t>& lightNumbers,
                      bool isNew)
    {
        if (whole_ && !isNew && lightNumbers == lightNumbers_) return false;
        whole_ = false;  // until all of it is uploaded
        lightNumbers_ = lightNumbers;
        // The lists sort lights, and hooks must find them where the host has them.
        std::vector<int32_t> inOrder;
        for (const int32_t place : clusters.places)
            inOrder.push_back(lightNumbers[static_cast<size_t>(place)]);
        numbers.update(inOrder.size(), inOrder.size() * sizeof(int32_t), inOrder.data());
        lights.update(clusters.lights.size() * kVectorsPerLight,
                      clusters.lights.size() * sizeof(LightVectors), clusters.lights.data());
        return true;
    }

    /// The same for area lights, from whose reach (reachOf) the clusters were made. Lights are
    /// uploaded each time: their shapes are not part of the clusters.
    bool updateAreas(const LightClusters& clusters, const std::vector<AreaVectors>& areas,
                     bool isNew)
    {
        std::vector<AreaVectors> inOrder;
        for (const int32_t place : clusters.places)
            inOrder.push_back(areas[static_cast<size_t>(place)]);
        lights.update(inOrder.size() * kVectorsPerAreaLight, inOrder.size() * sizeof(AreaVectors),
                      inOrder.data());
        if (whole_ && !isNew) return false;
        whole_ = false;
        return true;
    }

    /// Uploads the lists that the CPU has made.
    void uploadLists(const LightClusters& clusters)
    {
        indices.update(clusters.indices.size(), clusters.indices.size() * sizeof(int32_t),
                       clusters.indices.data());
        lists.update(clusters.lists.size() / 2, clusters.lists.size() * sizeof(int32_t),
                     clusters.lists.data());
        whole_ = true;
    }

    /// Makes room for lists that a shader makes of `listed` lights, and uploads what it needs.
    void reserveLists(const LightClusters& clusters, const ClusterWork& from, int listed)
    {
        // One list more has the number of indices in use: those of the list of all lights.
        const auto count = static_cast<size_t>(clusters.grid.count());
        const int32_t inUse[2] = {listed, 0};
        work.update(from.vectors.size(), from.vectors.size() * sizeof(glm::vec4),
                    from.vectors.data());
        indices.reserve(from.mostEntries, from.mostEntries * sizeof(int32_t));
        lists.reserve(count + 1, (count + 1) * sizeof inUse);
        lists.write(count * sizeof inUse, sizeof inUse, inUse);
    }

    /// To be called when a shader has made the lists.
    void finish() { whole_ = true; }
    /// Makes the next call upload everything.
    void forget() { whole_ = false; }

    BufferTexture lights, indices, lists, numbers, work;

private:
    std::vector<int32_t> lightNumbers_;
    bool whole_ = false;
};

}  // namespace fbrdf::gl
