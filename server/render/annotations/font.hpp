// A font at any size, through FreeType. Knows nothing of GL.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

struct FT_FaceRec_; // FreeType's

namespace ciel::render {

struct PlacedGlyph {
    std::uint32_t glyph = 0; // for draw; 0 is the box for what no font has
    int x = 0;               // pixels from the start of the text
};
struct Line {
    std::vector<PlacedGlyph> glyphs;
    int width = 0;
};
struct FontMetrics { // pixels, all positive
    int ascent = 0, descent = 0;
    int digit = 0; // height of a digit above the base line
};
struct GlyphImage {
    int left = 0, top = 0; // of the image: right of the pen, above the base line
    int width = 0, height = 0;
    std::vector<std::uint8_t> coverage; // two bytes a pixel, rows from the top: of the letter, and of it with its halo
};

// A font, and others of the machine for the characters that it lacks. Belongs to one thread. Sizes are pixels an em,
// those in `metrics` the font's own.
class Font {
public:
    // Opens the file when it is first needed. Every call throws Error naming the package when the font is not there.
    explicit Font(std::filesystem::path file = default_file());
    ~Font();
    Font(Font&&) noexcept;

    [[nodiscard]] FontMetrics metrics(int pixels);
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

} // namespace ciel::render
