// Motion.h - what turns on by itself in a window: the turntable, and lights that orbit.
#pragma once
#include <fbrdf/scene/Document.h>

#include <chrono>

namespace fbrdf::viewer {

class Motion {
public:
    /// Turns objects, ground and lights of a document by the time since the last call, where they
    /// are to turn. isStanding: nothing does.
    void follow(scene::Document& document, bool isStanding);
    /// Of the last call, since any moment.
    double seconds() const
    {
        return std::chrono::duration<double>(last_.time_since_epoch()).count();
    }

private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace fbrdf::viewer
