// Derivation. Between two replacing passes a surface contains a sum, which further passes multiply.
// The sum never exceeds S, the peaks of its passes added up, and no factor exceeds its own peak M.
// Light passes are therefore scaled by 1 / S and factors by 1 / M so that nothing clips, and a pass
// that reads the surface scales by S times all M.
#include "ScaledPlan.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Number.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace fbrdf {
namespace {

/// The content of a surface between two replacing passes.
struct Content {
    double sum = 0.0, factors = 1.0;
    double peak() const { return sum * factors; }
};

double largestOf(const Pass& pass, const Form& form, const Peaks& peaks)
{
    double sum = 0.0;
    for (const Part& part : pass.parts) {
        const auto& factors = form.terms[static_cast<size_t>(part.term)].factors;
        double product = part.scaled ? peaks.scales[static_cast<size_t>(part.term)] : 1.0;
        for (const int factor : part.factors)
            product *=
                peaks.tables[static_cast<size_t>(factors[static_cast<size_t>(factor)].table)];
        sum += product;
    }
    return sum;
}

double irradianceOf(const Pass& pass, const Peaks& peaks)
{
    double sum = 0.0;
    for (int i = 0; i < pass.lightCount; ++i)
        sum += peaks.lights[static_cast<size_t>(pass.firstLight + i)];
    return sum;
}

/// A divisor that is never 0: surfaces that nothing lights stay 0.
double orOne(double peak)
{
    return peak > 0.0 ? peak : 1.0;
}

/// Which content every pass writes and reads; -1 where it is none of ours, as for the target.
class Contents {
public:
    Contents(const Plan& plan)
    {
        std::array<int, 4> current{-1, -1, -1, -1};
        for (const Pass& pass : plan.passes) {
            int& content = current[static_cast<size_t>(pass.writes)];
            read_.push_back(pass.reads ? current[static_cast<size_t>(*pass.reads)] : -1);
            if (pass.writes != Surface::target && pass.blend == Blend::replace) {
                content = static_cast<int>(contents_.size());
                contents_.emplace_back();
            }
            written_.push_back(content);
            add(pass);
        }
    }

    const Content* read(size_t pass) const { return at(read_[pass]); }
    const Content* written(size_t pass) const { return at(written_[pass]); }

private:
    const Content* at(int index) const
    {
        return index < 0 ? nullptr : &contents_[static_cast<size_t>(index)];
    }
    void add(const Pass& pass)
    {
        const Content* from = at(read_.back());
        const double value = pass.largest * (from ? from->peak() : 1.0);
        if (written_.back() < 0) return;
        Content& into = contents_[static_cast<size_t>(written_.back())];
        if (pass.blend == Blend::multiply)
            into.factors *= value;
        else
            into.sum += value;
    }

    std::vector<Content> contents_;
    std::vector<int> read_, written_;  ///< indices into contents_, one for each pass
};

}  // namespace

Plan scaledPlan(Plan plan, const Form& form, const Peaks& peaks, ColourFormat surfaces)
{
    FBRDF_ASSERT(plan.feasible(), ==, true);
    FBRDF_ASSERT(peaks.tables.size(), ==, form.tables.size());
    FBRDF_ASSERT(peaks.scales.size(), ==, form.terms.size());
    for (Pass& pass : plan.passes)
        pass.largest = largestOf(pass, form, peaks) * (pass.lit ? irradianceOf(pass, peaks) : 1.0);
    const Contents contents(plan);
    for (size_t i = 0; i < plan.passes.size(); ++i) {
        Pass& pass = plan.passes[i];
        const Content* from = contents.read(i);
        const Content* into = contents.written(i);
        if (from) pass.gain *= orOne(from->peak());
        if (into) pass.gain /= orOne(pass.blend == Blend::multiply ? pass.largest : into->sum);
    }
    plan.surfaces = surfaces;
    for (const Pass& pass : plan.passes)
        if (pass.writes != Surface::target) plan.accumulation = surfaces;
    return plan;
}

Plan withSmallestSum(Plan plan, const Form& form, const PlanRequest& request,
                     const Capabilities& capabilities)
{
    const auto errorOf = [&](const Plan& of) {
        const ErrorBound error =
            errorBound(of, request.target, {}, request.roundings, request.otherUnit);
        return error.relative + error.absolute;  // of a value of 1, beyond which UNORM clamps
    };
    const double finest = errorOf(plan),
                 tolerance = sumTolerance(request.target, request.otherUnit);
    const std::pair<ColourFormat, bool> formats[] = {
        {ColourFormat::rgba8, true},
        {ColourFormat::rgba16f, capabilities.halfTargets || capabilities.floatTargets},
        {ColourFormat::rgba16, capabilities.unorm16Targets}};
    Plan scaled = scaledPlan(plan, form, *request.peaks, ColourFormat::rgba8);
    std::string others;
    for (const auto& [format, exists] : formats) {
        if (!exists) continue;
        scaled.surfaces = format;
        const double added = errorOf(scaled) - finest;
        const std::string what =
            std::string(colourFormatName(format)) + " adds up to " + numberText(added, 2);
        if (added <= tolerance) {
            scaled = scaledPlan(std::move(plan), form, *request.peaks, format);
            scaled.whyAccumulation =
                what + " to the error, of " + numberText(tolerance, 2) + " allowed";
            return scaled;
        }
        others += (others.empty() ? "" : ", ") + what;
    }
    plan.whyAccumulation = others + " to the error, of " + numberText(tolerance, 2) + " allowed";
    return plan;
}

}  // namespace fbrdf
