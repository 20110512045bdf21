// Font: measures and draws text at any size with FreeType. Independent of OpenGL.
#pragma once

#include "annotations/text_measure.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

struct FT_FaceRec_; // FreeType's type of a font face

namespace server::fonts {

struct PlacedGlyph {
    std::uint32_t glyph = 0; // for Font::draw; 0 is the box for a character that no font has
    int x = 0;               // position in pixels from the start of the text
};
struct Line {
    std::vector<PlacedGlyph> glyphs;
    int width = 0; // pixels
};
struct GlyphImage {
    int left = 0, top = 0;     // upper left corner, in pixels right of the pen and pixels above the baseline
    int width = 0, height = 0; // pixels
    // Two bytes per pixel: the coverage of the letter, then the coverage of the letter with its halo. The top row comes
    // first.
    std::vector<std::uint8_t> coverage;
};

// Not thread-safe. Sizes are in pixels per em. `metrics` describes the font itself, not its fallback fonts.
class Font final : public annotations::TextMeasure {
public:
    // The first call of another member function opens `file`. If `file` cannot be read, every call throws Error.
    explicit Font(std::filesystem::path file = default_file());
    ~Font() override;
    Font(Font&&) noexcept;

    [[nodiscard]] annotations::FontMetrics metrics(int pixels) override;
    [[nodiscard]] int width(std::string_view utf8, int pixels) override { return shape(utf8, pixels).width; }
    // Places glyphs from left to right with kerning, each at a whole pixel. Does not support scripts that join or
    // reorder letters. Malformed UTF-8 becomes U+FFFD, and control characters become spaces.
    [[nodiscard]] Line shape(std::string_view utf8, int pixels);
    [[nodiscard]] GlyphImage draw(std::uint32_t glyph, int pixels);

    [[nodiscard]] static std::filesystem::path default_file();

private:
    struct State;
    [[nodiscard]] State& opened();
    [[nodiscard]] FT_FaceRec_* at(int pixels, std::size_t face);
    std::filesystem::path file_;
    std::unique_ptr<State> state_;
};

// Returns the code points of `text`. Malformed sequences become U+FFFD (Unicode 15, 3.9).
[[nodiscard]] std::u32string decode_utf8(std::string_view text);

} // namespace server::fonts
