#include <fbrdf/fit/SolverSummary.h>
#include <fmt/format.h>

namespace fbrdf {
namespace {

std::string steps(int count)
{
    return std::to_string(count) + (count == 1 ? " step" : " steps");
}

std::string reason(const SolverSummary& summary)
{
    const std::string fall = fmt::format("{:.3g} %", 100.0 * summary.lastFall);
    switch (summary.termination) {
        case Termination::none: return "no solver ran";
        case Termination::solved: return "solved in " + steps(summary.iterations);
        case Termination::converged: return "converged after " + steps(summary.iterations);
        case Termination::plannedSteps:
            return "finished after " + steps(summary.iterations) +
                   ", the last lowered the cost by " + fall;
        case Termination::noDescent:
            return "no further step lowered the cost after " + steps(summary.iterations);
        case Termination::stepLimit:
            return "stopped at the limit of steps after " + steps(summary.iterations) +
                   " before it converged; the last lowered the cost by " + fall;
        case Termination::systemLimit:
            return "a linear system stopped at the limit of iterations before it was solved, "
                   "after " +
                   steps(summary.iterations);
    }
    return "?";
}

}  // namespace

const char* terminationName(Termination termination)
{
    switch (termination) {
        case Termination::none: return "none";
        case Termination::solved: return "solved";
        case Termination::converged: return "converged";
        case Termination::plannedSteps: return "planned_steps";
        case Termination::noDescent: return "no_descent";
        case Termination::stepLimit: return "step_limit";
        case Termination::systemLimit: return "system_limit";
    }
    return "?";
}

bool SolverSummary::hitLimit() const
{
    return termination == Termination::stepLimit || termination == Termination::systemLimit;
}

SolverSummary& SolverSummary::operator+=(const SolverSummary& next)
{
    iterations += next.iterations;
    systemIterations += next.systemIterations;
    if (next.termination == Termination::none) return *this;
    const bool keeps = hitLimit() && next.termination == Termination::plannedSteps;
    if (!keeps) termination = next.termination;
    cost = next.cost;
    lastFall = next.lastFall;
    return *this;
}

std::string SolverSummary::text() const
{
    std::string text = reason(*this);
    if (systemIterations > 0)
        text += " and " + std::to_string(systemIterations) + " iterations of conjugate gradients";
    if (termination != Termination::none) text += fmt::format(", cost {:.3g}", cost);
    return text;
}

}  // namespace fbrdf
