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
          numbers(device, GL_R32I, "light numbers")
    {
    }

    /// Uploads the lists. lightNumbers: for each light that the lists were made from, its place
    /// among the lights of the draw. isNew: false where the clusters are those of the last call.
    /// Leaves the array buffer bound. Throws Error(gl) where a buffer texture is too small for the
    /// lists.
    void update(const LightClusters& clusters, const std::vector<int32_t>& lightNumbers, bool isNew)
    {
        if (whole_ && !isNew && lightNumbers == lightNumbers_) return;
        whole_ = false;  // until all of it is uploaded
        lightNumbers_ = lightNumbers;
        // The lists sort lights, and hooks must find them where the host has them.
        std::vector<int32_t> inOrder;
        for (const int32_t place : clusters.places)
            inOrder.push_back(lightNumbers[static_cast<size_t>(place)]);
        numbers.update(inOrder.size(), inOrder.size() * sizeof(int32_t), inOrder.data());
        lights.update(clusters.lights.size() * kVectorsPerLight,
                      clusters.lights.size() * sizeof(LightVectors), clusters.lights.data());
        updateLists(clusters);
        whole_ = true;
    }

    /// The same for area lights, from whose reach (reachOf) the clusters were made. Lights are
    /// uploaded each time: their shapes are not part of the clusters.
    void update(const LightClusters& clusters, const std::vector<AreaVectors>& areas, bool isNew)
    {
        std::vector<AreaVectors> inOrder;
        for (const int32_t place : clusters.places)
            inOrder.push_back(areas[static_cast<size_t>(place)]);
        lights.update(inOrder.size() * kVectorsPerAreaLight, inOrder.size() * sizeof(AreaVectors),
                      inOrder.data());
        if (whole_ && !isNew) return;
        whole_ = false;
        updateLists(clusters);
        whole_ = true;
    }

    BufferTexture lights, indices, lists, numbers;

private:
    void updateLists(const LightClusters& clusters)
    {
        indices.update(clusters.indices.size(), clusters.indices.size() * sizeof(int32_t),
                       clusters.indices.data());
        lists.update(clusters.lists.size() / 2, clusters.lists.size() * sizeof(int32_t),
                     clusters.lists.data());
    }

    std::vector<int32_t> lightNumbers_;
    bool whole_ = false;
};

}  // namespace fbrdf::gl
