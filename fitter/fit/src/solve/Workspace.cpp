#include "solve/Workspace.h"

#include <algorithm>

namespace fbrdf {

SystemNumbers Workspace::any(size_t count)
{
    SystemNumbers numbers;
    {
        const std::lock_guard lock(mutex_);
        const auto found = std::find_if(kept_.begin(), kept_.end(),
                                        [count](const auto& kept) { return kept.size() == count; });
        if (found != kept_.end()) {
            numbers.swap(*found);
            kept_.erase(found);
        }
    }
    numbers.resize(count);
    return numbers;
}

SystemNumbers Workspace::zeros(size_t count)
{
    SystemNumbers numbers = any(count);
    std::fill(numbers.begin(), numbers.end(), 0.0);
    return numbers;
}

void Workspace::giveBack(SystemNumbers numbers)
{
    if (numbers.empty()) return;
    const std::lock_guard lock(mutex_);
    kept_.push_back(std::move(numbers));
}

}  // namespace fbrdf
