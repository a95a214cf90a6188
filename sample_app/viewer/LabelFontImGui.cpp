#include "LabelFont.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace fbrdf::viewer {
namespace {

constexpr int kLetterPixels = 13;  // of ImGui's own font, which is made for that size

/// The text with fewer and fewer letters of its middle.
std::string shortened(const std::string& text, size_t letters)
{
    const size_t head = (letters + 1) / 2;
    return text.substr(0, head) + "..." + text.substr(text.size() - (letters - head));
}

}  // namespace

struct LabelFont::State {
    ImFontAtlas atlas;
    const ImFont* font = nullptr;
    const unsigned char* coverage = nullptr;
    int width = 0, height = 0;

    void drawGlyph(scene::Image& image, const ImFontGlyph& glyph, int x, int y,
                   float radiance) const;
};

bool LabelFont::isThere()
{
    return true;
}

LabelFont::LabelFont(int scale) : state_(std::make_unique<State>())
{
    ImFontConfig config;
    config.SizePixels = static_cast<float>(kLetterPixels * scale);
    config.OversampleH = config.OversampleV = 1;
    config.PixelSnapH = true;
    state_->font = state_->atlas.AddFontDefault(&config);
    unsigned char* pixels = nullptr;
    state_->atlas.GetTexDataAsAlpha8(&pixels, &state_->width, &state_->height);
    state_->coverage = pixels;
}

LabelFont::~LabelFont() = default;

int LabelFont::height() const
{
    return static_cast<int>(state_->font->FontSize);
}

int LabelFont::widthOf(const std::string& text) const
{
    const ImVec2 size = state_->font->CalcTextSizeA(state_->font->FontSize, 1e9f, 0.0f, text.data(),
                                                    text.data() + text.size());
    return static_cast<int>(std::ceil(size.x));
}

void LabelFont::State::drawGlyph(scene::Image& image, const ImFontGlyph& glyph, int x, int y,
                                 float radiance) const
{
    const int left = x + static_cast<int>(glyph.X0), top = y + static_cast<int>(glyph.Y0);
    const int u = static_cast<int>(std::lround(glyph.U0 * static_cast<float>(width))),
              v = static_cast<int>(std::lround(glyph.V0 * static_cast<float>(height)));
    for (int row = 0; row < static_cast<int>(glyph.Y1 - glyph.Y0); ++row)
        for (int column = 0; column < static_cast<int>(glyph.X1 - glyph.X0); ++column) {
            const int px = left + column, py = top + row;
            if (px < 0 || py < 0 || px >= image.width || py >= image.height) continue;
            const float share =
                static_cast<float>(coverage[(v + row) * width + u + column]) / 255.0f;
            float* const pixel = image.pixel(px, py);
            for (int c = 0; c < 3; ++c) pixel[c] += share * (radiance - pixel[c]);
        }
}

void LabelFont::draw(scene::Image& image, const LabelPlace& place, const std::string& text,
                     float radiance) const
{
    std::string line = text;
    for (size_t letters = text.size(); letters > 0 && widthOf(line) > place.width; --letters)
        line = shortened(text, letters - 1);
    float x = static_cast<float>(place.x);
    for (const char letter : line) {
        const auto code = static_cast<unsigned char>(letter);
        const ImFontGlyph* const glyph = state_->font->FindGlyph(code < 128 ? code : '?');
        state_->drawGlyph(image, *glyph, static_cast<int>(x), place.y, radiance);
        x += glyph->AdvanceX;
    }
}

}  // namespace fbrdf::viewer
