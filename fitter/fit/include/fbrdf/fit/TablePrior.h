// TablePrior.h - what the log tables of materials look like: a Gaussian that a fit to few samples
// leans on where they decide nothing.
//
// The unknowns of one channel of a form are x ~ N(mean, sum_k m_k m_k^T + tau^2 S): the mean and
// the modes m_k are those of many known materials (principal components, each as long as its
// standard deviation), and S is the covariance that smoothness alone stands for. Every fit finds
// its own tau. R, G and B of a material count as three, so that one prior serves every colour.
// Tipping and Bishop 1999, "Probabilistic Principal Component Analysis", section 3;
// Nielsen, Jensen, Ramamoorthi 2015, "On Optimal, Minimal BRDF Sampling for Reflectance
// Acquisition", section 3, for reflectance.
#pragma once
#include <fbrdf/brdf/Form.h>

#include <string>
#include <string_view>
#include <vector>

namespace fbrdf {

/// A prior of the form hdio. Numbers are log2 texels (f in 1/sr): of T1 its texels in order, then
/// of T2 those that are not the mirror of an earlier one.
struct TablePrior {
    Form form;                              ///< formHdio of some size
    std::vector<float> mean;                ///< as many as there are numbers
    std::vector<std::vector<float>> modes;  ///< each as long as `mean`
};

/// The bytes of a prior file (docs/format.md): the mean in 16 bits, the modes in 8.
std::string tablePriorBytes(const TablePrior& prior);
/// Throws Error(input) naming `where` for anything else than such bytes.
TablePrior tablePriorFromBytes(std::string_view bytes, const std::string& where);

/// The prior that comes with the library; `fitter/prior.sh` made it.
TablePrior shippedTablePrior();

}  // namespace fbrdf
