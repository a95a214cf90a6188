#include "NearestName.h"

#include <fbrdf/base/Text.h>

#include <algorithm>

namespace fbrdf {
namespace {

// A specification is typed by hand; longer words are a mistake of another kind, and the distance
// is quadratic.
constexpr size_t kLongestWord = 64;

}  // namespace

size_t editDistance(const std::string& a, const std::string& b)
{
    const size_t width = b.size() + 1;
    std::vector<size_t> cost((a.size() + 1) * width);
    const auto at = [&](size_t i, size_t j) -> size_t& { return cost[i * width + j]; };
    for (size_t i = 0; i <= a.size(); ++i) at(i, 0) = i;
    for (size_t j = 0; j <= b.size(); ++j) at(0, j) = j;
    for (size_t i = 1; i <= a.size(); ++i)
        for (size_t j = 1; j <= b.size(); ++j) {
            const size_t replaced = at(i - 1, j - 1) + (a[i - 1] == b[j - 1] ? 0 : 1);
            at(i, j) = std::min({at(i - 1, j) + 1, at(i, j - 1) + 1, replaced});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
        }
    return cost.back();
}

std::string nearestName(const std::string& word, const std::vector<std::string>& names)
{
    if (word.empty() || word.size() > kLongestWord) return "";
    std::string nearest;
    size_t smallest = word.size() / 3 + 2;
    for (const std::string& name : names) {
        const size_t distance = editDistance(lowerCase(word), lowerCase(name));
        if (distance >= smallest) continue;
        smallest = distance;
        nearest = name;
    }
    return nearest;
}

std::string suggestion(const std::string& word, const std::vector<std::string>& names)
{
    const std::string nearest = nearestName(word, names);
    return nearest.empty() ? "" : ", did you mean '" + nearest + "'?";
}

}  // namespace fbrdf
