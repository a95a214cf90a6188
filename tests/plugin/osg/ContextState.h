// ContextState.h - what gl/StateList.h reads, for sources that see OSG's GL header: glad's cannot
// be beside it.
#pragma once
#include <fbrdf/headless/Context.h>

#include <map>
#include <string>
#include <vector>

namespace fbrdf::test {

/// State by name, of the compatibility context that is current.
using ContextState = std::map<std::string, std::vector<double>>;
ContextState contextState(HeadlessContext::Load load);

/// Names and values that differ, a line each; empty where nothing does.
std::string changes(const ContextState& before, const ContextState& after);

}  // namespace fbrdf::test
