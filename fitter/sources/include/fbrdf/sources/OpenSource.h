// OpenSource.h - the front door: a file of any known format, or an analytic model, becomes a
// Source.
#pragma once
#include <fbrdf/sources/Source.h>

#include <string>
#include <vector>

namespace fbrdf {

struct SourceOptions {
    bool cosine = false;  ///< CSV values include cos theta_o (--cosine)
};

/// Opens a file (recognised by content, then by extension) or an analytic model
/// "name:key=value,...". A file of several data sets takes a choice after its path:
/// FILE@0.532 (a wavelength in um), FILE#name or FILE#row (a material of a collection). A folder
/// may be a measurement in many files (pab). Materials (.fbrdf, the 2001 layout) are sources with
/// `evaluate`. Throws Error(usage) for an unknown model
/// or a parameter out of range, Error(input) for a file that is missing or invalid.
Source openSource(const std::string& spec, const SourceOptions& options = {});

/// The materials that a specification stands for, each as openSource takes it: all of a collection
/// for its FILE alone, those of a set of its materials.txt for FILE#set; for anything else the
/// specification itself. Throws Error(input) for a file that cannot be read.
std::vector<std::string> materialsOf(const std::string& spec);

}  // namespace fbrdf
