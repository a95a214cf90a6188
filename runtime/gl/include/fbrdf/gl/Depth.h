// Depth.h - how the host's depth buffer works: which depths a projection makes, which of two
// fragments is in front, and what an empty buffer contains.
#pragma once

namespace fbrdf::gl {

/// A fragment passes where its depth compares so with the depth that is stored.
enum class DepthTest { less, lessEqual, greater, greaterEqual };

/// The depths that a projection leaves in clip space, divided by w.
enum class ClipDepth {
    negativeOneToOne,  ///< OpenGL's own
    zeroToOne,         ///< needs glClipControl (Capabilities::clipControl)
};

/// The defaults are those of a new OpenGL context. A draw follows these options in every pass and
/// in the depth buffers of its own, which are cleared to `clear`.
struct DepthOptions {
    DepthTest test = DepthTest::less;
    ClipDepth clip = ClipDepth::negativeOneToOne;
    /// Window depths of the low and of the high end of `clip`, as glDepthRange takes them: in
    /// [0, 1], in either order.
    float rangeLow = 0.0f, rangeHigh = 1.0f;
    /// The value that the host clears its depth buffer to, in [0, 1]. Some depth of the range must
    /// pass the test against it.
    float clear = 1.0f;
};

/// Reversed depth: the projection leaves 1 at the near plane and 0 at the far one, or infinitely
/// far, and the larger depth is in front. With a float depth buffer this is precise everywhere.
inline DepthOptions reversedDepth()
{
    return {DepthTest::greater, ClipDepth::zeroToOne, 0.0f, 1.0f, 0.0f};
}

}  // namespace fbrdf::gl
