#include "formats/KeywordText.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/sources/Fields.h>

namespace fbrdf {
namespace {

/// Measurements have at most some hundred angles an axis.
constexpr long long kMostAngles = 100000;

}  // namespace

std::string_view KeywordText::word(const char* expected)
{
    std::string_view next;
    if (!words_.next(next)) throw fail(Found("the end of the file").expected(expected));
    return next;
}

double KeywordText::number()
{
    double value = 0.0;
    const std::string_view text = word("a number");
    if (!parseNumber(text, value)) throw fail(Found(inQuotes(text)).expected("a number"));
    return value;
}

float KeywordText::value()
{
    double value = 0.0;
    const std::string_view text = word("a value");
    if (!parseField(text, value)) throw fail(Found(inQuotes(text)).expected("a value"));
    return static_cast<float>(value);
}

int KeywordText::oneOf(const char* first, const char* second)
{
    const std::string value(word(first));
    if (!sameWord(value, first) && !sameWord(value, second))
        throw fail(Found(inQuotes(value)).expected(std::string(first) + " or " + second));
    return sameWord(value, second);
}

std::vector<double> KeywordText::angles()
{
    long long count = 0;
    const std::string_view text = word("a count");
    if (!parseInteger(text, count) || count < 1 || count > kMostAngles)
        throw fail(Found(inQuotes(text)).expected("a count from 1 to 100000"));
    std::vector<double> all;
    for (long long i = 0; i < count; ++i) all.push_back(number());
    return all;
}

Error KeywordText::fail(const std::string& what) const
{
    return lineError(file_, words_.line(), what);
}

}  // namespace fbrdf
