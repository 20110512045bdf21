// Cache of rasterized glyphs in one texture.
#pragma once

#include "fonts/font.hpp"
#include "render/context/gl.hpp"

#include <optional>
#include <unordered_map>

namespace server::render {

struct AtlasGlyph {
    int u = 0, v = 0, width = 0, height = 0; // texels
    int left = 0, top = 0;                   // offset in pixels from the pen position, as in fonts::GlyphImage
};

class GlyphAtlas {
public:
    GlyphAtlas(const Gl& gl, fonts::Font& font);

    // Returns null if the texture is full. Then call clear(), and find all glyphs again. `pixels`: font size.
    [[nodiscard]] const AtlasGlyph* find(std::uint32_t glyph, int pixels);
    // Removes all glyphs. Doubles the texture's side and returns true, or returns false if the side is already the
    // largest.
    bool clear();
    // Uploads new glyphs, and binds the texture to the active unit.
    void bind();
    [[nodiscard]] int side() const { return side_; }

private:
    void allocate(int side);
    [[nodiscard]] std::optional<AtlasGlyph> placed(const fonts::GlyphImage& image);

    const Gl& gl_;
    fonts::Font& font_;
    GLuint texture_ = 0;
    int side_ = 0;
    std::vector<std::uint8_t> texels_; // two bytes per texel: coverage of the letter, coverage with halo
    std::unordered_map<std::uint64_t, AtlasGlyph> glyphs_; // key: size in pixels << 32 | glyph
    int shelf_top_ = 0, shelf_height_ = 0, shelf_x_ = 0;   // the row that is being filled, in texels
    int changed_top_ = 0, changed_bottom_ = 0;             // range of texel rows not uploaded yet
};

} // namespace server::render
