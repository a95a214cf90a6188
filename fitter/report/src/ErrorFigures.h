// ErrorFigures.h - heat maps of the error by theta_h and theta_d, and the weakest places in words.
#pragma once
#include "ErrorBins.h"

#include <string>

namespace fbrdf {

/// Two figures: the median log error of each bin, and its share of the cosine-weighted squared
/// error.
std::string errorFigures(const ErrorBins& bins);

/// One sentence each on the bin of the largest median and the one of the largest share; empty
/// without samples.
std::string weakestPlaces(const ErrorBins& bins);

}  // namespace fbrdf
