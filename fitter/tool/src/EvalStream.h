// EvalStream.h - direction pairs in, values out, in the same order, in constant memory, on all
// cores.
#pragma once
#include "LineBlocks.h"

#include <fbrdf/metrics/StandardSphere.h>

#include <functional>
#include <string_view>

namespace fbrdf::tool {

enum class RowStyle {
    csv,     ///< r,g,b
    number,  ///< r alone
    json,    ///< [r,g,b] with ",\n" between rows; a number that is not finite is null
};

struct EvalRequest {
    BrdfFunction brdf;
    RowStyle style = RowStyle::csv;
    int threads = 0;  ///< 0: one a core
    /// Is called with each run of rows, in order, by one thread at a time.
    std::function<void(std::string_view rows)> write;
};

/// Evaluates every pair of `blocks`, header first. Throws Error(input) for a header or a row that
/// cannot be read, after the rows before it were written, and whatever `write` throws.
void evaluateStream(LineBlocks& blocks, const EvalRequest& request);

}  // namespace fbrdf::tool
