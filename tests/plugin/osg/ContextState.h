// ContextState.h - reads the state that gl/StateList.h lists, for sources that include OSG's GL
// header, beside which glad's cannot be included.
#pragma once
#include <fbrdf/headless/Context.h>

#include <map>
#include <string>
#include <vector>

namespace fbrdf::test {

/// The state of the compatibility context that is current, by name.
using ContextState = std::map<std::string, std::vector<double>>;
ContextState contextState(HeadlessContext::Load load);

/// The names and values that differ, a line each; empty where nothing differs.
std::string changes(const ContextState& before, const ContextState& after);

}  // namespace fbrdf::test
