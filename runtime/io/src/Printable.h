// Printable.h - text of a file inside a message, which stays one line whatever the text is.
#pragma once
#include <string>

namespace fbrdf {

/// The first 60 bytes, with '?' for every control character.
inline std::string printable(const std::string& text)
{
    std::string line = text.substr(0, 60);
    for (char& c : line)
        if (static_cast<unsigned char>(c) < 32 || c == 127) c = '?';
    return line;
}

}  // namespace fbrdf
