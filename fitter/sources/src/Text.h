// Text.h - lines, words and numbers of a text in memory, without copies and without the locale.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace fbrdf {

/// Walks the lines of a text; "\r\n" and a byte-order mark are taken off.
class LineReader {
public:
    explicit LineReader(std::string_view text);
    /// False at the end. The line comes without its end and may be blank.
    bool next(std::string_view& line);
    /// Does what next does, but skips blank lines and those that start with '#'.
    bool nextData(std::string_view& line);
    /// Number of the line that was read last, from 1.
    size_t number() const { return number_; }

private:
    std::string_view rest_;
    size_t number_ = 0;
};

/// Walks words separated by white space across lines; '#' starts a comment up to the line's end.
class WordReader {
public:
    explicit WordReader(std::string_view text) : rest_(text) {}
    bool next(std::string_view& word);
    /// Line of the word that was read last, from 1.
    size_t line() const { return wordLine_; }

private:
    std::string_view rest_;
    size_t line_ = 1, wordLine_ = 1;
};

std::string_view trimmed(std::string_view text);
std::string lowerCase(std::string_view text);
/// Replaces `fields` with the parts between separators, trimmed.
void splitFields(std::string_view line, char separator, std::vector<std::string_view>& fields);
/// Replaces `words` with the parts between white space.
void splitWords(std::string_view line, std::vector<std::string_view>& words);

/// True when the whole of `text` is a number; "nan" and "inf" are, and a number too large for
/// double becomes infinity.
bool parseNumber(std::string_view text, double& value);
/// True when the whole of `text` is a whole number without fraction or exponent.
bool parseInteger(std::string_view text, long long& value);

/// "'text'", cut to a length that suits a message, with unprintable bytes shown as '?'.
std::string quoted(std::string_view text);

/// True when the first kilobytes have no byte that does not occur in text.
bool looksLikeText(std::string_view bytes);

}  // namespace fbrdf
