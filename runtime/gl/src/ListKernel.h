// ListKernel.h - lists of lights made by a compute shader (cluster_lists.comp).
#pragma once
#include "ClusterBuffers.h"

#include <string>

namespace fbrdf::gl {

class ListKernel {
public:
    explicit ListKernel(const DevicePtr& device) : device_(device) {}

    /// Why this context makes no lists by itself; "" where it does. The first call builds the
    /// program; a driver that refuses it is not asked again.
    const std::string& whyNot();

    /// Why these lists have to be made by the CPU; "" where there is room for them.
    std::string whyTooMany(const ClusterWork& work) const;

    /// Makes the lists of clusters whose lights are in the buffers already. Expects both reasons to
    /// be empty. Changes the program that is in use and the array buffer. Throws Error(gl) where GL
    /// has no memory.
    void make(const LightClusters& clusters, const ClusterWork& work, ClusterBuffers& buffers);

private:
    void build();

    DevicePtr device_;
    Object program_;
    GLint grid_ = -1, listed_ = -1, margin_ = -1;
    bool isBuilt_ = false;
    std::string whyNot_;
};

}  // namespace fbrdf::gl
