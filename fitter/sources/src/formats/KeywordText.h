// KeywordText.h - texts of keywords and numbers that may stand anywhere across lines: what the two
// formats named .bsdf that are text share.
#pragma once
#include "InputFile.h"

#include <fbrdf/base/Text.h>

#include <string_view>
#include <vector>

namespace fbrdf {

/// Reads a file word by word. Comments from '#' to the end of a line are skipped.
class KeywordText {
public:
    explicit KeywordText(const InputFile& file) : file_(file), words_(file.bytes()) {}

    /// False at the end of the file.
    bool next(std::string_view& word) { return words_.next(word); }
    std::string_view word(const char* expected);
    double number();
    /// A number, or NaN for what stands for a missing one (Fields.h).
    float value();
    /// 0 for `first`, 1 for `second`, in any case of letters.
    int oneOf(const char* first, const char* second);
    /// A count from 1 to 100000 and as many numbers.
    std::vector<double> angles();
    /// Error(input) at the line of the last word.
    Error fail(const std::string& what) const;

private:
    const InputFile& file_;
    WordReader words_;
};

}  // namespace fbrdf
