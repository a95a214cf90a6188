// SurfacePool.h - the surfaces of all targets that were drawn to. Targets of one size share theirs,
// for what a draw leaves in them is never read again.
#pragma once
#include "Surfaces.h"

#include <memory>
#include <vector>

namespace fbrdf::gl {

class SurfacePool {
public:
    explicit SurfacePool(DevicePtr device) : device_(std::move(device)) {}

    /// Surfaces for a framebuffer of the host, created where there are none. Those that it had in
    /// another size are deleted, unless another framebuffer needs them. Returns null, after a
    /// warning, where the driver cannot draw to them; it is not asked again for the same format.
    const Surfaces* find(GLuint framebuffer, const SurfaceFormat& format);

    /// Deletes the surfaces of framebuffers that the host has deleted, and those that the target
    /// has in another size: its name may be that of a framebuffer that was deleted.
    void evict(const Target& target);

private:
    struct Entry {
        std::unique_ptr<Surfaces> surfaces;
        std::vector<GLuint> framebuffers;  ///< of the host, that use them
    };
    /// Forgets the framebuffers for which the predicate, called with an entry and a framebuffer, is
    /// true, and entries that then have none.
    template <class IsGone>
    void forget(IsGone isGone);

    DevicePtr device_;
    std::vector<Entry> entries_;
};

}  // namespace fbrdf::gl
