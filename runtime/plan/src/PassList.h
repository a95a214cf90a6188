// PassList.h - a list of passes that knows what each surface contains, and therefore how the next
// pass tests depth and blends.
#pragma once
#include <fbrdf/plan/Plan.h>

namespace fbrdf {

/// The number of fetches that one factor needs: 0 or 1.
int lookupsOf(const Form& form, int term, int factor);
int lookupsOf(const Form& form, int term, const std::vector<int>& factors);

class PassList {
public:
    explicit PassList(const Form& form) : form_(form) {}

    /// Drops the content of the surface: the next pass to it replaces.
    void restart(Surface surface) { fresh_[static_cast<size_t>(surface)] = true; }
    /// Appends the pass after setting its depth, its look-ups and, unless it multiplies, its blend.
    void append(Pass pass);
    /// Lets the last pass, which must not multiply, add lobes as well.
    void addToLast(const LobeShare& lobes);
    const std::vector<Pass>& passes() const { return passes_; }

private:
    const Form& form_;
    std::vector<Pass> passes_;
    bool fresh_[4] = {true, true, true, true};  ///< indexed by Surface
    bool targetLaid_ = false, offscreenLaid_ = false;
};

}  // namespace fbrdf
