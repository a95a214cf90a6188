#include "ContextState.h"

#include "gl/StateList.h"

namespace fbrdf::test {

ContextState contextState(HeadlessContext::Load load)
{
    return snapshot(loadGl(load), false);
}

std::string changes(const ContextState& before, const ContextState& after)
{
    return difference(before, after);
}

}  // namespace fbrdf::test
