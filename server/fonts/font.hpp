// A font at any size, through FreeType. Knows nothing of GL.
#pragma once

#include "annotations/text_measure.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

struct FT_FaceRec_; // FreeType's

namespace ciel::fonts {

struct PlacedGlyph {
    std::uint32_t glyph = 0; // for draw; 0 is the box for what no font has
    int x = 0;               // pixels from the start of the text
};
struct Line {
    std::vector<PlacedGlyph> glyphs;
    int width = 0;
};
struct GlyphImage {
    int left = 0, top = 0; // of the image: right of the pen, above the base line
    int width = 0, height = 0;
    std::vector<std::uint8_t> coverage; // two bytes a pixel, rows from the top: of the letter, and of it with its halo
};

// A font, and others of the machine for the characters that it lacks. Belongs to one thread. Sizes are pixels an em,
// those in `metrics` the font's own.
class Font final : public annotations::TextMeasure {
public:
    // Opens the file when it is first needed. Every call throws Error naming the package when the font is not there.
    explicit Font(std::filesystem::path file = default_file());
    ~Font() override;
    Font(Font&&) noexcept;

    [[nodiscard]] annotations::FontMetrics metrics(int pixels) override;
    [[nodiscard]] int width(std::string_view utf8, int pixels) override { return shape(utf8, pixels).width; }
    // Left to right with kerning, each glyph on a whole pixel; scripts that join or reorder letters are not shaped.
    // Bytes that are no UTF-8 become U+FFFD, control characters spaces.
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

[[nodiscard]] std::u32string decode_utf8(std::string_view text); // malformed sequences as U+FFFD (Unicode 15, 3.9)

} // namespace ciel::fonts
