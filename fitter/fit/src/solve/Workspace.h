// Workspace.h - memory for sums that is used again from step to step: the pages of normal equations
// cost more to get from the system, again and again, than the sums in them.
#pragma once
#include "solve/HugePages.h"

#include <mutex>

namespace fbrdf {

/// Safe to use from threads.
class Workspace {
public:
    /// `count` zeros.
    SystemNumbers zeros(size_t count);
    /// `count` numbers of any value.
    SystemNumbers any(size_t count);
    void giveBack(SystemNumbers numbers);

private:
    std::mutex mutex_;
    std::vector<SystemNumbers> kept_;
};

/// An array of a workspace, which gets it back. `workspace` must outlive the object.
class WorkArray {
public:
    WorkArray() = default;
    WorkArray(Workspace& workspace, size_t count)
        : workspace_(&workspace), values_(workspace.zeros(count))
    {
    }
    WorkArray(WorkArray&& other) noexcept { swap(other); }
    WorkArray& operator=(WorkArray&& other) noexcept
    {
        swap(other);
        return *this;
    }
    ~WorkArray()
    {
        if (workspace_) workspace_->giveBack(std::move(values_));
    }

    SystemNumbers& values() { return values_; }
    const SystemNumbers& values() const { return values_; }

private:
    void swap(WorkArray& other)
    {
        std::swap(workspace_, other.workspace_);
        values_.swap(other.values_);
    }

    Workspace* workspace_ = nullptr;
    SystemNumbers values_;
};

}  // namespace fbrdf
