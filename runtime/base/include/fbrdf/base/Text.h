// Text.h - lines, words and numbers of a text in memory, without copies and without the locale.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace fbrdf {

/// Walks the lines of a text. A line ends with "\n", "\r\n" or "\r"; a UTF-8 byte order mark before
/// the first line is skipped.
class LineReader {
public:
    explicit LineReader(std::string_view text);
    /// False at the end. The line comes without its end and may be blank.
    bool next(std::string_view& line);
    /// Does what next does, but skips blank lines and those that start with '#'.
    bool nextData(std::string_view& line);
    /// Does what nextData does, and adds the lines that follow while a double quote is open, as it
    /// is where a quoted field has a line break in it (RFC 4180).
    bool nextRecord(std::string_view& record);
    /// Number of the line that was read last, from 1.
    size_t number() const { return number_; }

private:
    bool addLine(std::string_view& record);

    std::string_view rest_;
    size_t lineFeed_ = 0;  ///< bytes of `rest_` before its first "\n"
    size_t number_ = 0;
};

/// Walks words separated by white space across lines; '#' starts a comment up to the line's end. A
/// UTF-8 byte order mark before the first word is skipped.
class WordReader {
public:
    explicit WordReader(std::string_view text);
    bool next(std::string_view& word);
    /// Line of the word that was read last, from 1.
    size_t line() const { return wordLine_; }

private:
    void skipSpace();

    std::string_view rest_;
    size_t line_ = 1, wordLine_ = 1;
};

/// The text after its UTF-8 byte order mark, if it has one.
std::string_view withoutByteOrderMark(std::string_view text);
std::string_view trimmed(std::string_view text);
/// A to Z become lower case; other characters stay, in every locale.
std::string lowerCase(std::string_view text);
/// True when the two differ in the case of A to Z at most.
bool sameWord(std::string_view a, std::string_view b);
/// Replaces `fields` with the parts between separators, trimmed. Quotes have no meaning here.
void splitFields(std::string_view line, char separator, std::vector<std::string_view>& fields);
/// Replaces `words` with the parts between white space.
void splitWords(std::string_view line, std::vector<std::string_view>& words);

/// True when the whole of `text` is a number; "nan" and "inf" are, and a number too large for
/// double becomes infinity. The decimal sign is a point.
bool parseNumber(std::string_view text, double& value);
/// Does what parseNumber does, but takes one comma as the decimal sign too ("0,5"). For text whose
/// fields are not separated by commas.
bool parseLocalNumber(std::string_view text, double& value);
/// True when the whole of `text` is a whole number without fraction or exponent.
bool parseInteger(std::string_view text, long long& value);

/// "'text'", cut to a length that suits a message, with unprintable bytes shown as '?'.
std::string inQuotes(std::string_view text);

/// True when the first kilobytes have no byte that does not occur in text.
bool looksLikeText(std::string_view bytes);

}  // namespace fbrdf
