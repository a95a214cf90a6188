#include <fbrdf/base/Text.h>
#include <fbrdf/sources/Fields.h>

#include <algorithm>
#include <array>
#include <limits>

namespace fbrdf {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\v\f";

bool hasOutsideQuotes(std::string_view line, char wanted)
{
    bool inside = false;
    for (const char c : line) {
        if (c == '"') inside = !inside;
        if (c == wanted && !inside) return true;
    }
    return false;
}

/// True where commas can only be decimal signs: words between blanks, none of which ends in a comma
/// or has two, or a point beside one.
bool hasDecimalCommas(std::string_view line)
{
    std::vector<std::string_view> words;
    splitWords(line, words);
    return words.size() > 1 && std::all_of(words.begin(), words.end(), [](std::string_view word) {
               double ignored = 0.0;
               return parseLocalNumber(word, ignored);
           });
}

char characterOf(Separator separator)
{
    return separator == Separator::semicolon ? ';' : separator == Separator::tab ? '\t' : ',';
}

/// One past the quote that ends the field which starts with one, or 0 where none does.
size_t afterClosingQuote(std::string_view text)
{
    for (size_t i = 1; i < text.size(); ++i) {
        if (text[i] != '"') continue;
        if (i + 1 == text.size() || text[i + 1] != '"') return i + 1;
        ++i;
    }
    return 0;
}

/// Where the field that starts the text ends: at its separator, or at the end.
size_t endOfField(std::string_view text, Separator separator)
{
    const size_t begin = text.find_first_not_of(separator == Separator::tab ? " \r" : kBlanks);
    size_t from = 0;
    if (begin != std::string_view::npos && text[begin] == '"') {
        const size_t closed = afterClosingQuote(text.substr(begin));
        from = closed > 0 ? begin + closed : 0;
    }
    const size_t end = separator == Separator::blanks ? text.find_first_of(kBlanks, from)
                                                      : text.find(characterOf(separator), from);
    return std::min(end, text.size());
}

std::string_view withoutQuotes(std::string_view field)
{
    const bool isQuoted = field.size() >= 2 && field.front() == '"' && field.back() == '"';
    return isQuoted ? trimmed(field.substr(1, field.size() - 2)) : field;
}

void skipBlanks(std::string_view& text)
{
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
}

}  // namespace

const char* nameOf(Separator separator)
{
    constexpr std::array<const char*, 4> kNames = {"commas", "semicolons", "tabs", "blanks"};
    return kNames[static_cast<size_t>(separator)];
}

Separator separatorOfNames(std::string_view line)
{
    for (const Separator separator : {Separator::semicolon, Separator::comma, Separator::tab})
        if (hasOutsideQuotes(line, characterOf(separator))) return separator;
    return Separator::blanks;
}

Separator separatorOfNumbers(std::string_view line)
{
    if (hasOutsideQuotes(line, ';')) return Separator::semicolon;
    if (!hasOutsideQuotes(line, ',') || hasDecimalCommas(line)) return Separator::blanks;
    return Separator::comma;
}

FieldReader::FieldReader(std::string_view line, Separator separator)
    : rest_(line), separator_(separator), more_(true)
{
    if (separator_ != Separator::blanks) return;
    skipBlanks(rest_);
    more_ = !rest_.empty();
}

bool FieldReader::next(std::string_view& field)
{
    if (!more_) return false;
    const size_t end = endOfField(rest_, separator_);
    field = withoutQuotes(trimmed(rest_.substr(0, end)));
    if (separator_ == Separator::blanks) {
        rest_.remove_prefix(end);
        skipBlanks(rest_);
        more_ = !rest_.empty();
    } else {
        more_ = end < rest_.size();
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
    }
    return true;
}

void splitFields(std::string_view line, Separator separator, std::vector<std::string_view>& fields)
{
    fields.clear();
    FieldReader reader(line, separator);
    for (std::string_view field; reader.next(field);) fields.push_back(field);
}

bool isMissingField(std::string_view field)
{
    // The last three are how the run-time library of Microsoft's compilers writes such numbers.
    constexpr std::array<std::string_view, 14> kMissing = {
        "",  "na", "n/a",     "#n/a",    "null",     "none",   "missing",
        "-", ".",  "#value!", "#div/0!", "nan(ind)", "1.#ind", "1.#qnan"};
    if (!field.empty() && field.front() == '-' && field.size() > 1) field.remove_prefix(1);
    return std::any_of(kMissing.begin(), kMissing.end(),
                       [&](std::string_view name) { return sameWord(name, field); });
}

bool parseField(std::string_view field, double& value)
{
    if (parseLocalNumber(field, value)) return true;
    if (!isMissingField(field)) return false;
    value = std::numeric_limits<double>::quiet_NaN();
    return true;
}

}  // namespace fbrdf
