#include "PassList.h"

#include <fbrdf/base/Assert.h>

namespace fbrdf {
namespace {

int lookupsOf(const Form& form, const Pass& pass)
{
    int count = (pass.reads ? 1 : 0) + pass.lobes.lookups();
    for (const Part& part : pass.parts)
        for (const int factor : part.factors) {
            const auto& factors = form.terms[static_cast<size_t>(part.term)].factors;
            const bool repeats = dependsOnLight(factors[static_cast<size_t>(factor)]);
            count += fbrdf::lookupsOf(form, part.term, factor) * (repeats ? pass.lightCount : 1);
        }
    return count;
}

}  // namespace

int lookupsOf(const Form& form, int term, int factor)
{
    const Factor& f = form.terms[static_cast<size_t>(term)].factors[static_cast<size_t>(factor)];
    return form.tables[static_cast<size_t>(f.table)].uniform ? 0 : 1;
}

int lookupsOf(const Form& form, int term, const std::vector<int>& factors)
{
    int count = 0;
    for (const int factor : factors) count += lookupsOf(form, term, factor);
    return count;
}

void PassList::append(Pass pass)
{
    bool& laid = pass.writes == Surface::target ? targetLaid_ : offscreenLaid_;
    bool& fresh = fresh_[static_cast<size_t>(pass.writes)];
    pass.depth = laid ? Depth::match : Depth::write;
    if (fresh)
        pass.blend = Blend::replace;
    else if (pass.blend != Blend::multiply)
        pass.blend = Blend::add;
    laid = true;
    fresh = false;
    pass.lookups = lookupsOf(form_, pass);
    passes_.push_back(std::move(pass));
}

void PassList::addToLast(const LobeShare& lobes)
{
    FBRDF_ASSERT(passes_.empty(), ==, false);
    FBRDF_ASSERT(passes_.back().blend != Blend::multiply, ==, true);
    passes_.back().lobes = lobes;
    passes_.back().lookups = lookupsOf(form_, passes_.back());
}

}  // namespace fbrdf
