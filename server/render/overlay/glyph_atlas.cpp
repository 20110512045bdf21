#include "render/overlay/glyph_atlas.hpp"

#include <algorithm>

namespace server::render {
namespace {
constexpr int first_side = 512; // side of the first texture in texels; it has room for about 600 glyphs of 13 pixels
constexpr int last_side = 4096;
constexpr std::size_t texel_bytes = 2;
} // namespace

GlyphAtlas::GlyphAtlas(const Gl& gl, fonts::Font& font) : gl_(gl), font_(font) {
    gl_.GenTextures(1, &texture_);
    gl_.BindTexture(GL_TEXTURE_2D, texture_);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        gl_.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
}

void GlyphAtlas::allocate(int side) {
    side_ = side;
    texels_.assign(texel_bytes * static_cast<std::size_t>(side) * static_cast<std::size_t>(side), 0);
    glyphs_.clear();
    shelf_top_ = shelf_height_ = shelf_x_ = 0;
    changed_top_ = changed_bottom_ = 0;
    gl_.BindTexture(GL_TEXTURE_2D, texture_);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RG8, side, side, 0, GL_RG, GL_UNSIGNED_BYTE, texels_.data());
}

bool GlyphAtlas::clear() {
    const bool can_grow = side_ < last_side;
    allocate(can_grow ? 2 * side_ : side_);
    return can_grow;
}

std::optional<AtlasGlyph> GlyphAtlas::placed(const fonts::GlyphImage& image) {
    if (image.width > side_) return {};
    if (shelf_x_ + image.width > side_) {
        shelf_top_ += shelf_height_;
        shelf_height_ = shelf_x_ = 0;
    }
    if (shelf_top_ + image.height > side_) return {};
    const AtlasGlyph glyph{shelf_x_, shelf_top_, image.width, image.height, image.left, image.top};
    shelf_x_ += image.width;
    shelf_height_ = std::max(shelf_height_, image.height);
    return glyph;
}

const AtlasGlyph* GlyphAtlas::find(std::uint32_t glyph, int pixels) {
    if (side_ == 0) allocate(first_side);
    const std::uint64_t key = (static_cast<std::uint64_t>(pixels) << 32U) | glyph;
    if (const auto known = glyphs_.find(key); known != glyphs_.end()) return &known->second;
    const fonts::GlyphImage image = font_.draw(glyph, pixels);
    const auto place = placed(image);
    if (!place) return nullptr;
    const std::size_t row_bytes = texel_bytes * static_cast<std::size_t>(image.width);
    for (int row = 0; row < image.height; ++row) {
        const auto to = texel_bytes * (static_cast<std::size_t>(place->v + row) * static_cast<std::size_t>(side_) +
                                       static_cast<std::size_t>(place->u));
        std::copy_n(image.coverage.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(row) * row_bytes),
                    row_bytes, texels_.begin() + static_cast<std::ptrdiff_t>(to));
    }
    if (changed_top_ == changed_bottom_) changed_top_ = place->v;
    changed_top_ = std::min(changed_top_, place->v);
    changed_bottom_ = std::max(changed_bottom_, place->v + image.height);
    return &glyphs_.emplace(key, *place).first->second;
}

void GlyphAtlas::bind() {
    if (side_ == 0) allocate(first_side);
    gl_.BindTexture(GL_TEXTURE_2D, texture_);
    if (changed_top_ == changed_bottom_) return;
    const auto first = texel_bytes * static_cast<std::size_t>(changed_top_) * static_cast<std::size_t>(side_);
    gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, changed_top_, side_, changed_bottom_ - changed_top_, GL_RG, GL_UNSIGNED_BYTE,
                      texels_.data() + first);
    changed_top_ = changed_bottom_ = 0;
}

} // namespace server::render
