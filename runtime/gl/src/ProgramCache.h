// ProgramCache.h - linked programs, found by their text: materials of one form and one set of sizes
// share them. A program is deleted when no material needs it.
#pragma once
#include "CompiledHooks.h"
#include "Program.h"

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <unordered_map>
#include <vector>

namespace fbrdf::gl {

class ProgramCache {
public:
    /// `mostIdle`: RendererOptions::idlePrograms.
    ProgramCache(DevicePtr device, size_t mostIdle)
        : device_(std::move(device)), mostIdle_(mostIdle)
    {
    }

    /// Builds at first use. Throws Error(gl) with the compiler's log, the first time and every time
    /// after (without compiling again while the material exists).
    const Program& find(const MaterialResources& material, const ProgramSpec& spec,
                        const SurfaceOptions& surface);

    /// Throws Error(input) for hooks that do not compile.
    void check(const Hooks& hooks);

    /// Deletes the programs that only materials and hooks that are gone have needed, but for the
    /// kMostUnused last ones, and those that are idle beyond the limit. Programs that find() has
    /// returned may be among them. To be called whenever a draw begins.
    void evict();

    /// A host that releases a material before it makes the next one of the same form should not
    /// wait for a compiler.
    static constexpr size_t kMostUnused = 8;
    static constexpr uint64_t kIdleDraws = 256;  ///< what so many did not use is idle

private:
    struct Text {
        std::string vertex, fragment;
        bool operator<(const Text& other) const
        {
            return std::tie(fragment, vertex) < std::tie(other.fragment, other.vertex);
        }
    };
    struct Entry {
        std::shared_ptr<const Object> vertexShader;
        std::unique_ptr<const Program> program;  ///< null where it could not be built
        std::string failure;
        uint64_t lastUse = 0;  ///< the number of that draw
    };
    /// A program that a material has needed. These are few, and comparing them allocates nothing.
    struct Known {
        uint64_t hooks = 0;  ///< 0: none
        bool normalMap = false, derivedTangent = false;
        ProgramSpec spec;
        std::shared_ptr<Entry> entry;
        bool isFor(const ProgramSpec& wanted, const SurfaceOptions& surface) const;
    };
    Entry& entryOf(const MaterialResources& material, const ProgramSpec& spec,
                   const SurfaceOptions& surface);
    std::shared_ptr<Entry> shared(const MaterialResources& material, const Text& text);
    void build(Entry& entry, const MaterialResources& material, const Text& text);
    std::shared_ptr<const Object> vertexShader(const std::string& text);
    void release(std::shared_ptr<Entry> entry);
    void evictHooks();
    void evictIdle();
    void eraseExpired();
    /// Takes those that isGone() out of what materials know, and gives their entries to take().
    template <class IsGone, class Take>
    void forget(const IsGone& isGone, const Take& take);

    DevicePtr device_;
    size_t mostIdle_;
    uint64_t draws_ = 0;
    std::unordered_map<uint64_t, std::vector<Known>> known_;  ///< by the id of the material
    std::map<Text, std::weak_ptr<Entry>> entries_;
    std::map<std::string, std::weak_ptr<const Object>> vertexShaders_;  ///< by text
    std::deque<std::shared_ptr<Entry>> unused_;                         ///< the latest last
};

}  // namespace fbrdf::gl
