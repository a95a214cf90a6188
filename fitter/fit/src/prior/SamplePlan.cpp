#include <fbrdf/fit/SamplePlan.h>

#include "prior/ShippedData.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Number.h>
#include <fbrdf/brdf/HalfDifference.h>

#include <array>
#include <charconv>

namespace fbrdf {
namespace {

constexpr std::string_view kColumns = "theta_h,theta_d,phi_d";
constexpr double kPlanDegree = kPi / 180.0;

// The next line without its end, taken off the front.
std::string_view nextLine(std::string_view& text)
{
    const size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

std::array<double, 3> anglesFrom(std::string_view line, const std::string& where)
{
    std::array<double, 3> angles{};
    const char* at = line.data();
    const char* end = line.data() + line.size();
    for (size_t k = 0; k < angles.size(); ++k) {
        if (k > 0 && at != end && *at == ',') ++at;
        const auto result = std::from_chars(at, end, angles[k]);
        if (result.ec != std::errc() || !(angles[k] >= 0.0 && angles[k] <= 180.0))
            throw Error(ErrorKind::input, where,
                        Found("'" + std::string(line.substr(0, 40)) + "'")
                            .expected("three angles of 0 to 180 degrees"));
        at = result.ptr;
    }
    return angles;
}

}  // namespace

std::string planText(const SamplePlan& plan)
{
    std::string text(kColumns);
    text += "\n";
    for (const auto& pair : plan) {
        const HalfDifference a = halfDifferenceFromPair(pair);
        text += fixedText(a.theta_h / kPlanDegree, 3) + "," +
                fixedText(a.theta_d / kPlanDegree, 2) + "," +
                fixedText(std::abs(a.phi_d) / kPlanDegree, 2) + "\n";
    }
    return text;
}

SamplePlan planFromText(std::string_view text, const std::string& where)
{
    if (nextLine(text) != kColumns)
        throw Error(ErrorKind::input, where,
                    Found("another first line").expected(std::string(kColumns)));
    SamplePlan plan;
    while (!text.empty()) {
        const auto angles = anglesFrom(nextLine(text), where);
        plan.push_back(pairFromHalfDifference(
            {angles[0] * kPlanDegree, 0.0, angles[1] * kPlanDegree, angles[2] * kPlanDegree}));
    }
    return plan;
}

SamplePlan shippedPlan(PlanSpace space, size_t count)
{
    SamplePlan plan = planFromText(
        space == PlanSpace::hemisphere ? planOfHemisphere() : planInPlane(), "the shipped plan");
    if (count < 1 || count > plan.size())
        throw Error(ErrorKind::usage, "plan",
                    Found(std::to_string(count) + " samples")
                        .expected("1 to " + std::to_string(plan.size())));
    plan.resize(count);
    return plan;
}

}  // namespace fbrdf
