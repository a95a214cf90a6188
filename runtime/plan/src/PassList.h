// PassList.h - passes as they are appended: knows what each surface holds, and so how the next pass
// tests depth and blends.
#pragma once
#include <fbrdf/plan/Plan.h>

namespace fbrdf {

/// Fetches of one factor: 0 or 1.
int lookupsOf(const Form& form, int term, int factor);
int lookupsOf(const Form& form, int term, const std::vector<int>& factors);

class PassList {
public:
    explicit PassList(const Form& form) : form_(form) {}

    /// What the surface holds no longer matters: the next pass to it replaces.
    void restart(Surface surface) { fresh_[static_cast<size_t>(surface)] = true; }
    /// Appends with depth, blend (unless it multiplies) and look-ups set.
    void append(Pass pass);
    const std::vector<Pass>& passes() const { return passes_; }

private:
    const Form& form_;
    std::vector<Pass> passes_;
    bool fresh_[4] = {true, true, true, true};  ///< by Surface
    bool targetLaid_ = false, offscreenLaid_ = false;
};

}  // namespace fbrdf
