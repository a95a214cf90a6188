// Robustness.h - how much worse the picture of a fit gets when its data have noise, zeros or
// spikes, or are few.
#pragma once
#include "bench/BenchFit.h"

#include <string>
#include <vector>

namespace fbrdf::tool {

/// One way of making data worse, and how much a fit may lose by it on average.
struct Trouble {
    std::string name;    ///< "noise", "a tenth", "1,458 samples"
    double mayLose = 0;  ///< dB of PSNR of the standard sphere
    std::vector<Sample> (*apply)(const std::vector<Sample>& samples, uint64_t seed) = nullptr;
};
const std::vector<Trouble>& troubles();

struct RobustScore {
    std::string material, form;
    double clean = 0;          ///< dB, PSNR of the fit to the data as they are
    std::vector<double> lost;  ///< dB against it, one a trouble
};

/// Each of our forms fitted to a source as it is and in trouble. The samples are the source's own,
/// or 131,072 of a function that has none. Throws Error(input) for a source without a function,
/// because there is no true picture to compare with.
std::vector<RobustScore> robustness(const std::string& source, const BenchOptions& options,
                                    Progress& progress);

/// True when the mean losses of every form are within what each trouble allows.
bool allHold(const std::vector<RobustScore>& scores);
std::string robustnessText(const std::vector<RobustScore>& scores);
Json robustnessJson(const std::vector<RobustScore>& scores);

}  // namespace fbrdf::tool
