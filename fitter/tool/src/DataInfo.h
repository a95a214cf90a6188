// DataInfo.h - what `info` reports about a data file or a model.
#pragma once
#include "Albedo.h"
#include "Errors.h"

#include <fbrdf/sources/Source.h>

#include <optional>
#include <string>
#include <vector>

namespace fbrdf::tool {

struct DataInfo {
    std::string name, format, description;
    std::vector<std::string> assumptions;  ///< Source::assumptions
    bool isotropic = false, function = false, sampled = false;
    SampleReport report;
    uint64_t usable = 0;
    Vec3f floor{0.0f}, least{0.0f}, most{0.0f};
    std::optional<double> reciprocity;  ///< median |ln f(a, b) / f(b, a)|
    std::string reciprocityNote;        ///< over which pairs, or why there is none
    /// PSNR of the standard sphere, in dB, of the mean of f(a, b) and f(b, a): about the best that
    /// a reciprocal form can reach. Absent for samples, and where f is reciprocal.
    std::optional<double> reciprocalPsnr;
    /// Of an isotropic function: the median |ln f(a, b) / f(a', b')| of pairs and their mirror
    /// images at the plane of incidence, and the PSNR of the mean of both where they differ by 2 %.
    /// Tables over angles have one value for both.
    std::optional<double> mirror, mirrorPsnr;
    std::vector<AlbedoAt> albedo;  ///< of a function
};

DataInfo dataInfo(const Source& source, int threads);

Json jsonOf(const DataInfo& info);
std::string textOf(const DataInfo& info);

}  // namespace fbrdf::tool
