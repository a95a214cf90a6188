// Restrained.h - a form fitted to all of the data, and kept from inventing what no sample has.
#pragma once
#include "FitContext.h"
#include "search/Stray.h"

namespace fbrdf {

struct Restrained {
    Fitted fitted;
    SampleErrors all;    ///< on all samples
    double allMark = 0;  ///< markOf them
    Stray::Mean stray;
    double inventedHue = 0;  ///< of the fit before it was drawn back

    /// Half of allMark and twice inventedHue: what errors between the samples count beside those on
    /// them. A form that had to be drawn back follows its samples by what they do not say.
    double mark() const;
};

/// The form fitted to the data, or to the data and what draws it back where it strays, if it then
/// strays less and no error on all samples is larger by more than a tenth and twice what it strays
/// less. `stray` is that of the context's data.
Restrained fitRestrained(const FitContext& context, const Form& form, const Stray& stray);

}  // namespace fbrdf
