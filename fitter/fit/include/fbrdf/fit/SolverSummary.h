// SolverSummary.h - where the iterations of a fit end, and where those of one fit did.
#pragma once
#include <string>

namespace fbrdf {

/// Each limit is the bound of the inequality in its comment.
struct SolverOptions {
    /// A descent has converged when a step lowers the cost by less than this share of it:
    /// (before - after) / before < costTolerance.
    double costTolerance = 1e-4;
    /// A descent ends, converged or not, when steps == maxSteps.
    int maxSteps = 24;
    /// A step that does not lower the cost is tried again with ten times the damping (Levenberg
    /// and Marquardt), while damping < maxDamping, relative to the diagonal of the system.
    double maxDamping = 1e3;
    /// A system too large to be factored is solved when |b - A x| <= systemTolerance |b| in every
    /// channel. It starts from a solution that is near: a pqp of 64 x 64 texels has the same errors
    /// with 1e-2 as with 1e-3, in a sixth of the iterations.
    double systemTolerance = 1e-2;
    /// Its iterations end, solved or not, when iterations == maxSystemIterations.
    int maxSystemIterations = 2000;
};

/// Why a solver stopped.
enum class Termination {
    none,          ///< there was nothing to solve: the tables were written down, or found by SVD
    solved,        ///< the problem is linear and all of its steps were taken
    converged,     ///< the last step lowered the cost by less than costTolerance
    plannedSteps,  ///< it took the few steps that a start which had converged elsewhere needs
    noDescent,     ///< no step below maxDamping lowers the cost
    stepLimit,     ///< a descent came to maxSteps
    systemLimit,   ///< a large system came to maxSystemIterations
};
const char* terminationName(Termination termination);  ///< "none", "solved", ...

struct SolverSummary {
    Termination termination = Termination::none;
    int iterations = 0;        ///< Gauss-Newton steps that were tried, on all grids and parts
    int systemIterations = 0;  ///< of conjugate gradients, in all of these steps
    double cost = 0.0;         ///< weighted mean of squared residuals; log2 units in the metric log
    double lastFall = 0.0;     ///< by what share the last step of a descent lowered the cost

    /// A limit ended the iterations before they converged: more of them would fit better.
    bool hitLimit() const;
    /// What was done next with the solution, as part of the same fit: iterations add up, and the
    /// later reason counts, unless planned steps followed a limit that was hit.
    SolverSummary& operator+=(const SolverSummary& next);
    /// One sentence: "converged after 12 steps, cost 0.00314".
    std::string text() const;
};

}  // namespace fbrdf
