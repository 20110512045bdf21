// A font at any size, through FreeType. Independent of OpenGL.
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
    std::uint32_t glyph = 0; // for draw; 0: box for a character that no font has
    int x = 0;               // pixels from the start of the text
};
struct Line {
    std::vector<PlacedGlyph> glyphs;
    int width = 0;
};
struct GlyphImage {
    int left = 0, top = 0; // of the image: pixels right of the pen, above the base line
    int width = 0, height = 0;
    std::vector<std::uint8_t> coverage; // two bytes a pixel, rows from the top: letter, letter with halo
};

// A font, with other fonts of the machine for characters that it lacks. For one thread only. Sizes are pixels per em.
// `metrics` describes the font itself, not the others.
class Font final : public annotations::TextMeasure {
public:
    // Opens the file on first use. Every call throws Error, naming the package, when the font is missing.
    explicit Font(std::filesystem::path file = default_file());
    ~Font() override;
    Font(Font&&) noexcept;

    [[nodiscard]] annotations::FontMetrics metrics(int pixels) override;
    [[nodiscard]] int width(std::string_view utf8, int pixels) override { return shape(utf8, pixels).width; }
    // Places glyphs left to right with kerning, each on a whole pixel. Scripts that join or reorder letters are not
    // shaped. Malformed UTF-8 becomes U+FFFD, control characters become spaces.
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
