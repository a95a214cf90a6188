// LearnPrior.h - a prior from materials that are known.
#pragma once
#include <fbrdf/fit/TablePrior.h>
#include <fbrdf/sources/Source.h>

#include <vector>

namespace fbrdf {

/// Materials as a prior is learned from them. Unknowns are log2 texels in the order of the solver.
struct KnownMaterials {
    Form form;
    std::vector<std::vector<double>> tables;  ///< fitted to each channel of each material
    /// Unknowns x unknowns, the lower triangle, columns contiguous: what a change of log2 texels
    /// changes in pictures of the standard sphere, mean over materials of J^T J where J is the
    /// derivative of pixels that are not white, each material scaled to a trace of 1.
    std::vector<double> seen;
    /// The same for the samples of a grid over the half and difference angles, trace 1.
    std::vector<double> sampled;
};

/// Fits the form hdio of its default size to functions. Throws Error(usage) for none, Error(fit)
/// naming a source that is no function.
KnownMaterials knownMaterials(const std::vector<Source>& functions, int threads);

/// The principal components of the tables, by what is seen of them. `modes` at least 1, at most as
/// many as tables; throws Error(usage) otherwise.
TablePrior learnTablePrior(const KnownMaterials& known, int modes);

}  // namespace fbrdf
