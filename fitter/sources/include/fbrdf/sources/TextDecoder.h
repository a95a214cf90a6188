// TextDecoder.h - from the bytes of a text file to UTF-8 with lines that end in "\n".
// The byte order mark decides: UTF-16 little endian, UTF-16 big endian, or UTF-8 where it is that
// of UTF-8 or missing (Unicode Standard, section 23.8). It is not part of the text.
#pragma once
#include <string>
#include <string_view>

namespace fbrdf {

/// True for bytes that start with a byte order mark of UTF-16.
bool startsAsUtf16(std::string_view bytes);

/// Decodes a file piece by piece, wherever the pieces end. Units of UTF-16 that are no character
/// become U+FFFD.
class TextDecoder {
public:
    /// Appends what can be decoded of the bytes so far to `text`.
    void append(std::string_view bytes, std::string& text);
    /// Appends what an unfinished end stands for. To be called after the last piece.
    void finish(std::string& text);

private:
    enum class Encoding { unknown, utf8, utf16Little, utf16Big };

    void decide();
    void decode(std::string_view bytes, std::string& text);
    void addUnit(unsigned unit, std::string& text);
    void addCharacter(unsigned character, std::string& text);
    void addLines(std::string_view bytes, std::string& text);

    Encoding encoding_ = Encoding::unknown;
    std::string pending_;     ///< bytes before the encoding is known, or half a unit
    unsigned surrogate_ = 0;  ///< the first of two units, 0 for none
    bool afterReturn_ = false;
};

}  // namespace fbrdf
