// Draws annotations over a finished picture, with one buffer, one program and one draw call.
#pragma once

#include "annotations/overlay.hpp"
#include "render/frame/frame.hpp"
#include "render/overlay/glyph_atlas.hpp"
#include "render/target/touched_tiles.hpp"

namespace server::render {

class OverlayPainter {
public:
    explicit OverlayPainter(const Gl& gl);
    OverlayPainter(const OverlayPainter&) = delete;
    OverlayPainter& operator=(const OverlayPainter&) = delete;

    // Computes the vertices of the frame's annotations. Throws Error when the font is not installed.
    void prepare(const Frame& frame);
    // Marks the tiles that the annotations cover. `height`: height of the picture in pixels.
    void touch(TouchedTiles& touched, int height) const;
    // Draws the prepared annotations onto the bound framebuffer, without depth test.
    void draw(const Frame& frame);

private:
    struct Vertex {
        // x, y: pixels from the top left. u, v depend on `kind`: the texel of a glyph, or the distance across a stroke
        // in pixels, or the distance outside a plate in widths of its edge.
        float x, y, u, v;
        annotations::Ink ink;
        float kind, half_width;
        bool operator==(const Vertex&) const = default;
    };
    void add_quad(const Vertex& vertex, const annotations::Box& box, const annotations::Box& texels);
    void add(const annotations::Plate& back);
    void add(const annotations::Fill& fill);
    void add(const annotations::Stroke& stroke, double width, const annotations::Ink& ink);
    void add(const annotations::Triangle& triangle);
    // Returns false if the atlas is full.
    [[nodiscard]] bool add(const annotations::Label& label, bool halo, const annotations::Ink& ink);
    [[nodiscard]] bool add_labels(const annotations::Overlay& overlay);
    void build(const annotations::Overlay& overlay);

    const Gl& gl_;
    fonts::Font font_;
    GlyphAtlas atlas_;
    GLuint program_ = 0, array_ = 0, buffer_ = 0;
    GLint viewport_ = -1, glyphs_ = -1;
    std::vector<Vertex> vertices_, uploaded_;
};

} // namespace server::render
