// NearestName.h - the name that somebody may have meant.
#pragma once
#include <string>
#include <vector>

namespace fbrdf {

/// Insertions, deletions, replacements and swaps of neighbours between two words (restricted
/// Damerau-Levenshtein distance).
size_t editDistance(const std::string& a, const std::string& b);

/// The nearest of `names`, whatever the case of letters, or "" when none is within a third of the
/// word's length plus one.
std::string nearestName(const std::string& word, const std::vector<std::string>& names);

/// ", did you mean 'NAME'?", or "".
std::string suggestion(const std::string& word, const std::vector<std::string>& names);

}  // namespace fbrdf
