// Fields.h - one line of a table of text, taken apart by rules that hold in every reader.
// Separators: a semicolon, a comma, a tab, or blanks. A comma separates unless the line is
// separated otherwise; there it is the decimal sign. Fields may be in double quotes (RFC 4180),
// which are taken off, as are the blanks around a field. A field without a value is empty, or one
// of NA, N/A, #N/A, NULL, None, -, . and what programs write for a number that is none.
#pragma once
#include <string_view>
#include <vector>

namespace fbrdf {

enum class Separator { comma, semicolon, tab, blanks };

/// "commas", "semicolons", "tabs" or "blanks".
const char* nameOf(Separator separator);

/// What separates the names of a header: the first that occurs outside quotes of semicolon, comma
/// and tab, else blanks.
Separator separatorOfNames(std::string_view line);

/// What separates the numbers of a line without names. A semicolon does where there is one. Commas
/// do, unless every word between blanks looks like a number with a decimal comma ("0,5 1 2,25").
/// Anything else is blanks, and tabs count as blanks.
Separator separatorOfNumbers(std::string_view line);

/// Walks the fields of a line from left to right.
class FieldReader {
public:
    FieldReader(std::string_view line, Separator separator);
    /// False after the last field. Between blanks no field is empty; otherwise n separators make
    /// n + 1 fields.
    bool next(std::string_view& field);

private:
    std::string_view rest_;
    Separator separator_;
    bool more_;
};

/// Replaces `fields` by those of the line.
void splitFields(std::string_view line, Separator separator, std::vector<std::string_view>& fields);

/// True for a field that stands for a value that is missing.
bool isMissingField(std::string_view field);

/// True for a number (parseLocalNumber), and for a missing value, which becomes NaN.
bool parseField(std::string_view field, double& value);

}  // namespace fbrdf
