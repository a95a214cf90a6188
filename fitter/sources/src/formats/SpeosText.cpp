#include "formats/SpeosText.h"

#include "SampleRow.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/base/Number.h>
#include <fbrdf/base/Text.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

constexpr std::string_view kWhiteSpace = " \t\r\n";
/// Tables have at most some hundred angles an axis.
constexpr size_t kMostTableAngles = 100000;

void requireAscendingAngles(const SpeosText& text, const std::vector<double>& angles, double most)
{
    double last = -1.0;
    for (const double angle : angles) {
        if (!(angle > last && angle >= 0.0 && angle <= most + 1e-6))
            throw text.fail(Found("the angle " + numberText(angle))
                                .expected("ascending ones from 0 to " + numberText(most)));
        last = angle;
    }
}

/// Weight of node i in the trapezoidal rule over angles in degrees, in radians.
double stepOf(const std::vector<double>& angles, size_t i)
{
    const double before = i == 0 ? angles[i] : angles[i - 1];
    const double after = i + 1 == angles.size() ? angles[i] : angles[i + 1];
    return 0.5 * (after - before) * kDegree;
}

}  // namespace

std::string_view SpeosText::line()
{
    const size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
    const std::string_view text = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + (rest_.substr(end, 2) == "\r\n" ? 2 : 1), rest_.size()));
    return text;
}

void SpeosText::skip(size_t characters)
{
    rest_.remove_prefix(std::min(characters, rest_.size()));
    line();
}

double SpeosText::number(const char* what)
{
    rest_.remove_prefix(std::min(rest_.find_first_not_of(kWhiteSpace), rest_.size()));
    const std::string_view word = rest_.substr(0, rest_.find_first_of(kWhiteSpace));
    double value = 0.0;
    if (word.empty()) throw fail(Found("the end of the file").expected(what));
    if (!parseLocalNumber(word, value)) throw fail(Found(inQuotes(word)).expected(what));
    rest_.remove_prefix(word.size());
    return value;
}

size_t SpeosText::count(const char* what, size_t least, size_t most)
{
    const double value = number(what);
    if (!(value >= double(least) && value <= double(most)) || value != std::floor(value))
        throw fail(Found(numberText(value) + " as " + what)
                       .expected("a whole number from " + std::to_string(least) + " to " +
                                 std::to_string(most)));
    return static_cast<size_t>(value);
}

std::vector<double> SpeosText::numbers(size_t n, const char* what)
{
    if (n > rest_.size())
        throw fail(Found("fewer than " + std::to_string(n) + " numbers")
                       .expected(std::string("as many of ") + what));
    std::vector<double> values(n);
    for (double& value : values) value = number(what);
    return values;
}

Error SpeosText::fail(const std::string& what) const
{
    const size_t read = file_.size() - rest_.size();
    const std::string_view before = file_.bytes().substr(0, read);
    return lineError(file_, size_t(std::count(before.begin(), before.end(), '\n')) + 1, what);
}

double SpeosGrid::integral(const float* values, bool cosine) const
{
    double sum = 0.0;
    for (size_t t = 0; t < theta.size(); ++t) {
        const double angle = theta[t] * kDegree;
        const double ring = std::sin(angle) * (cosine ? std::cos(angle) : 1.0) * stepOf(theta, t);
        for (size_t p = 0; p < phi.size(); ++p)
            sum += ring * stepOf(phi, p) * double(values[t * phi.size() + p]);
    }
    constexpr double kHalfTurn = 180.5;
    return phi.back() < kHalfTurn ? 2.0 * sum : sum;
}

double SpeosGrid::weight(size_t t, size_t p) const
{
    if (theta[t] == 0.0) return 1.0 / double(phi.size());
    const bool closed = phi.front() == 0.0 && phi.back() == 360.0;
    return closed && (p == 0 || p + 1 == phi.size()) ? 0.5 : 1.0;
}

void readSpeosTitle(SpeosText& text)
{
    text.line();
    const size_t mode = text.count("the mode, 0 for text", 0, 1);
    if (mode != 0)
        throw text.fail(Found("mode 1 (binary)").expected("0 (text): export it as text"));
    text.line();
    text.line();  // the comment
    const size_t characters = text.count("the length of the description", 0, 1000000);
    text.line();
    text.skip(characters);
}

SpeosHead readSpeosFlags(SpeosText& text)
{
    SpeosHead head;
    head.reflection = text.count("0 or 1 for reflection", 0, 1) == 1;
    text.count("0 or 1 for transmission", 0, 1);
    head.times_cosine = text.count("0 or 1 for the type of values", 0, 1) == 0;
    if (!head.reflection) throw text.fail(Found("transmission alone").expected("reflection"));
    return head;
}

SpeosGrid readSpeosTable(SpeosText& text, std::vector<float>& values)
{
    SpeosGrid grid;
    const size_t thetas = text.count("a count of zenith angles", 2, kMostTableAngles);
    const size_t phis = text.count("a count of azimuths", 2, kMostTableAngles);
    grid.phi = text.numbers(phis, "azimuths");
    requireAscendingAngles(text, grid.phi, 360.0);
    for (size_t t = 0; t < thetas; ++t) {
        grid.theta.push_back(text.number("a zenith angle"));
        for (size_t p = 0; p < phis; ++p)
            values.push_back(static_cast<float>(text.number("a value")));
    }
    requireAscendingAngles(text, grid.theta, 90.0);
    return grid;
}

Vec3d speosLight(double incidence, double turn)
{
    return directionFromDegrees(incidence, 180.0 + turn);
}

}  // namespace fbrdf
