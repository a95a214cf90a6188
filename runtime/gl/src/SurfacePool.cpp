#include "SurfacePool.h"

#include <algorithm>

namespace fbrdf::gl {

template <class IsGone>
void SurfacePool::forget(IsGone isGone)
{
    for (Entry& entry : entries_) {
        auto& users = entry.framebuffers;
        users.erase(std::remove_if(users.begin(), users.end(),
                                   [&](GLuint framebuffer) { return isGone(entry, framebuffer); }),
                    users.end());
    }
    entries_.erase(std::remove_if(entries_.begin(), entries_.end(),
                                  [](const Entry& entry) { return entry.framebuffers.empty(); }),
                   entries_.end());
}

const Surfaces* SurfacePool::find(GLuint framebuffer, const SurfaceFormat& format)
{
    // A plan of another item may need another colour format in the same frame: those are kept.
    forget([&](const Entry& entry, GLuint user) {
        return user == framebuffer && !entry.surfaces->format().fitsTargetOf(format);
    });
    auto entry = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& candidate) {
        return candidate.surfaces->format() == format;
    });
    if (entry == entries_.end()) {
        entries_.push_back({std::make_unique<Surfaces>(device_, format), {}});
        entry = entries_.end() - 1;
    }
    auto& users = entry->framebuffers;
    if (std::find(users.begin(), users.end(), framebuffer) == users.end())
        users.push_back(framebuffer);
    // Surfaces that cannot be drawn to stay as an entry, so that the driver is asked once.
    return entry->surfaces->isUsable() ? entry->surfaces.get() : nullptr;
}

// The window, framebuffer 0, is always there.
void SurfacePool::evict(const Target& target)
{
    if (!device_->capabilities.framebufferObjects) return;
    forget([&](const Entry& entry, GLuint framebuffer) {
        const SurfaceFormat& format = entry.surfaces->format();
        if (framebuffer == target.framebuffer)
            return format.width != target.width || format.height != target.height;
        return framebuffer != 0 && !device_->gl.IsFramebuffer(framebuffer);
    });
}

}  // namespace fbrdf::gl
