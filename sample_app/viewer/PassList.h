// PassList.h - the passes of the last draw, and what each costs the GPU.
#pragma once
#include "GlFunctions.h"

#include <fbrdf/gl/PassWatch.h>

#include <optional>
#include <string>
#include <vector>

namespace fbrdf::viewer {

struct PassRow {
    std::string material;  ///< its name
    std::string name;      ///< "2/3 light 5"
    int lookups = 0;       ///< of a fragment
    Blend blend = Blend::replace;
    /// On the GPU, by a timer query; of a draw that was a few frames ago. None where the context
    /// has no such queries, and until the first one has ended.
    std::optional<double> milliseconds = {};
};

/// What a pass is, for people.
std::string passName(const gl::PassEvent& event);

/// Belongs to the context that is current when it is made.
class PassList {
public:
    static constexpr size_t kMostRows = 48;  ///< those beyond are counted only

    explicit PassList(gl::LoadFunction load);
    ~PassList();
    PassList(const PassList&) = delete;
    PassList& operator=(const PassList&) = delete;

    /// For the renderer whose passes are listed; points to this.
    gl::PassWatch watch();
    /// Forgets the draw before, and takes the times that are there by now. It waits for none.
    void begin();
    const std::vector<PassRow>& rows() const { return rows_; }
    int left() const { return left_; }  ///< passes that have no row

private:
    /// Of the pass of one row.
    struct Timer {
        GLuint query = 0;
        bool isPending = false;
        std::string name;  ///< of the pass that was timed
        std::optional<double> milliseconds = {};
    };
    void passBegins(const gl::PassEvent& event);
    void passEnds();

    GladGLContext gl_;
    bool hasTimers_ = false;
    std::vector<Timer> timers_;
    std::vector<PassRow> rows_;
    int left_ = 0;
    bool isTimed_ = false;  ///< the pass that has begun
};

}  // namespace fbrdf::viewer
