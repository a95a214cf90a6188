// Text files of every encoding that a byte order mark can name, in pieces of every size.
#include <fbrdf/sources/TextDecoder.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

using namespace fbrdf;

namespace {

std::string decoded(std::string_view bytes, size_t piece)
{
    TextDecoder decoder;
    std::string text;
    for (; !bytes.empty(); bytes.remove_prefix(std::min(piece, bytes.size())))
        decoder.append(bytes.substr(0, piece), text);
    decoder.finish(text);
    return text;
}

void expectDecoded(const std::string& bytes, const std::string& text)
{
    for (size_t piece = 1; piece <= bytes.size(); ++piece)
        EXPECT_EQ(decoded(bytes, piece), text) << "pieces of " << piece;
}

/// UTF-16 with its mark of text that is ASCII.
std::string utf16(std::string_view text, bool little)
{
    std::string bytes = little ? "\xFF\xFE" : "\xFE\xFF";
    for (const char c : text) bytes += little ? std::string({c, '\0'}) : std::string({'\0', c});
    return bytes;
}

}  // namespace

TEST(TextDecoder, EveryEncodingGivesTheSameText)
{
    expectDecoded("a,b\n1,2\n", "a,b\n1,2\n");
    expectDecoded(
        "\xEF\xBB\xBF"
        "a,b\n1,2\n",
        "a,b\n1,2\n");
    expectDecoded(utf16("a,b\n1,2\n", true), "a,b\n1,2\n");
    expectDecoded(utf16("a,b\r\n1,2\r\n", false), "a,b\n1,2\n");
}

TEST(TextDecoder, EveryLineEndBecomesALineFeed)
{
    expectDecoded("a\rb\r\nc\n\rd\r\r\n", "a\nb\nc\n\nd\n\n");
}

TEST(TextDecoder, CharactersBeyondAsciiBecomeUtf8)
{
    // U+00B0, U+20AC, U+1F600
    expectDecoded(std::string("\xFF\xFE\xB0\x00\xAC\x20\x3D\xD8\x00\xDE", 10),
                  "\xC2\xB0\xE2\x82\xAC\xF0\x9F\x98\x80");
}

TEST(TextDecoder, WhatIsNoCharacterIsReplaced)
{
    const std::string replacement = "\xEF\xBF\xBD";
    expectDecoded(std::string("\xFF\xFE\x3D\xD8"
                              "a\0",
                              6),
                  replacement + "a");
    expectDecoded(std::string("\xFF\xFE\x00\xDE", 4), replacement);
    expectDecoded(
        "\xFF\xFE"
        "a",
        replacement);
    expectDecoded(std::string("\xFF\xFE\x3D\xD8", 4), replacement);
}

TEST(TextDecoder, ShortFilesStayAsTheyAre)
{
    for (const char* text : {"", "a", "ab", "\xEF\xBB"}) EXPECT_EQ(decoded(text, 1), text);
    EXPECT_EQ(decoded("\xEF\xBB\xBF", 2), "");
    EXPECT_EQ(decoded("\xFF\xFE", 1), "");
}
