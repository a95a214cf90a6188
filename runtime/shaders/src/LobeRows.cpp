#include <fbrdf/base/Assert.h>
#include <fbrdf/shaders/LobeRows.h>

namespace fbrdf {

std::vector<glm::vec4> lobeRows(const LobeTable& table, const LobeShare& share)
{
    FBRDF_ASSERT(layoutOf(table) == share.table, ==, true);
    std::vector<glm::vec4> rows;
    rows.reserve(static_cast<size_t>(share.knotVectors()));
    const auto first = static_cast<size_t>(share.first), count = static_cast<size_t>(share.count);
    for (const LobeKnot& knot : table.knots) {
        const auto tilt = [&](size_t k) { return k < count ? knot.lobes[first + k].tilt : 0.0f; };
        rows.emplace_back(share.cosine ? knot.cosine : Vec3f(0.0f), tilt(0));
        for (size_t k = 0; k < count; ++k)
            rows.emplace_back(knot.lobes[first + k].weight, knot.lobes[first + k].level);
        if (share.rows() > share.count + 1) rows.emplace_back(tilt(1), tilt(2), 0.0f, 0.0f);
    }
    return rows;
}

glm::vec2 lobeBend(const LobeTable& table)
{
    return table.acrossTangent ? glm::vec2(0.0f, table.spread) : glm::vec2(table.spread, 0.0f);
}

}  // namespace fbrdf
