#include "render/overlay/overlay_painter.hpp"

#include "annotations/layout.hpp"
#include "render/context/shader_program.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace server::render {
namespace {

constexpr float flat = 0, soft = 1, letter = 2, letter_halo = 3, plate = 4; // values of Vertex::kind

constexpr const char* overlay_vertex = R"(#version 330 core
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 place;
layout(location = 2) in vec4 ink;
layout(location = 3) in vec2 style;
uniform vec2 viewport;
out Mark {
    vec2 place;
    vec4 ink;
    flat vec2 style;
} mark;
void main() {
    gl_Position = vec4(position.x / viewport.x * 2.0 - 1.0, 1.0 - position.y / viewport.y * 2.0, 0.0, 1.0);
    mark.place = place;
    mark.ink = ink;
    mark.style = style;
}
)";

constexpr const char* overlay_fragment = R"(#version 330 core
uniform sampler2D glyphs;
in Mark {
    vec2 place;
    vec4 ink;
    flat vec2 style;
} mark;
out vec4 picture;
void main() {
    float cover = 1.0;
    if (mark.style.x > 3.5) {
        cover = 1.0 - smoothstep(0.0, 1.0, length(mark.place)); // mark.place: distance outside the box, in edge widths
    } else if (mark.style.x > 1.5) {
        vec2 coverage = texelFetch(glyphs, ivec2(mark.place), 0).rg;
        cover = mark.style.x > 2.5 ? coverage.g : coverage.r;
    } else if (mark.style.x > 0.5) {
        cover = clamp(mark.style.y + 0.5 - abs(mark.place.x), 0.0, 1.0);
    }
    picture = vec4(mark.ink.rgb, mark.ink.a * cover);
}
)";

double halo_width(const annotations::Stroke& stroke) { return stroke.width + 2 * std::max(1.0, stroke.width * 0.9); }

} // namespace

OverlayPainter::OverlayPainter(const Gl& gl)
    : gl_(gl), atlas_(gl_, font_),
      program_(link_stages(gl_, {{GL_VERTEX_SHADER, overlay_vertex}, {GL_FRAGMENT_SHADER, overlay_fragment}})),
      viewport_(gl_.GetUniformLocation(program_, "viewport")), glyphs_(gl_.GetUniformLocation(program_, "glyphs")) {
    gl_.GenVertexArrays(1, &array_);
    gl_.GenBuffers(1, &buffer_);
    gl_.BindVertexArray(array_);
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
    const auto attribute = [&](GLuint index, int components, std::size_t offset) {
        gl_.EnableVertexAttribArray(index);
        gl_.VertexAttribPointer(
            index, components, GL_FLOAT, GL_FALSE, sizeof(Vertex),
            reinterpret_cast<const void*>(offset)); // NOLINT(performance-no-int-to-ptr): GL's own way
    };
    attribute(0, 2, offsetof(Vertex, x));
    attribute(1, 2, offsetof(Vertex, u));
    attribute(2, 4, offsetof(Vertex, ink));
    attribute(3, 2, offsetof(Vertex, kind));
}

void OverlayPainter::add_quad(const Vertex& vertex, const annotations::Box& box, const annotations::Box& texels) {
    for (const auto& [right, bottom] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}) {
        Vertex corner = vertex;
        corner.x = static_cast<float>(right == 1 ? box.right : box.left);
        corner.y = static_cast<float>(bottom == 1 ? box.bottom : box.top);
        corner.u = static_cast<float>(right == 1 ? texels.right : texels.left);
        corner.v = static_cast<float>(bottom == 1 ? texels.bottom : texels.top);
        vertices_.push_back(corner);
    }
}

void OverlayPainter::add(const annotations::Plate& back) {
    const annotations::Box& box = back.box;
    const std::array<double, 4> xs{box.left - back.edge, box.left, box.right, box.right + back.edge};
    const std::array<double, 4> ys{box.top - back.edge, box.top, box.bottom, box.bottom + back.edge};
    const std::array<double, 4> away{1, 0, 0, 1};
    for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t first = vertices_.size();
            add_quad({0, 0, 0, 0, back.top, plate, 0}, {xs[i], ys[j], xs[i + 1], ys[j + 1]},
                     {away[i], away[j], away[i + 1], away[j + 1]});
            for (std::size_t k = first; k < vertices_.size(); ++k)
                if (vertices_[k].y >= static_cast<float>(box.bottom)) vertices_[k].ink = back.bottom;
        }
}

void OverlayPainter::add(const annotations::Fill& fill) {
    const std::size_t first = vertices_.size();
    add_quad({0, 0, 0, 0, fill.top, flat, 0}, fill.box, {});
    for (std::size_t i = first; i < vertices_.size(); ++i)
        if (vertices_[i].y > static_cast<float>(fill.box.top)) vertices_[i].ink = fill.bottom;
}

void OverlayPainter::add(const annotations::Stroke& stroke, double width, const annotations::Ink& ink) {
    const double dx = stroke.to.x - stroke.from.x;
    const double dy = stroke.to.y - stroke.from.y;
    const double length = std::hypot(dx, dy);
    if (!(length > 0)) return;
    const double reach = width / 2 + 0.5;
    // Strokes have square caps, so that strokes that meet leave no gap.
    const annotations::PicturePoint along{dx / length * width / 2, dy / length * width / 2};
    const annotations::PicturePoint across{-dy / length * reach, dx / length * reach};
    for (const auto& [end, side] : {std::pair(0, -1), {1, -1}, {1, 1}, {0, -1}, {1, 1}, {0, 1}}) {
        const annotations::PicturePoint at =
            end == 1 ? annotations::PicturePoint{stroke.to.x + along.x, stroke.to.y + along.y}
                     : annotations::PicturePoint{stroke.from.x - along.x, stroke.from.y - along.y};
        vertices_.push_back({static_cast<float>(at.x + side * across.x), static_cast<float>(at.y + side * across.y),
                             static_cast<float>(side * reach), 0, ink, soft, static_cast<float>(width / 2)});
    }
}

void OverlayPainter::add(const annotations::Triangle& triangle) {
    for (const annotations::PicturePoint& corner : triangle.corners)
        vertices_.push_back({static_cast<float>(corner.x), static_cast<float>(corner.y), 0, 0, triangle.ink, flat, 0});
}

bool OverlayPainter::add(const annotations::Label& label, bool halo, const annotations::Ink& ink) {
    for (const auto& [glyph, x] : font_.shape(label.text, label.pixels).glyphs) {
        const AtlasGlyph* kept = atlas_.find(glyph, label.pixels);
        if (kept == nullptr) return false;
        const double left = label.x + x + kept->left;
        const double top = label.y - kept->top;
        add_quad({0, 0, 0, 0, ink, halo ? letter_halo : letter, 0}, {left, top, left + kept->width, top + kept->height},
                 {static_cast<double>(kept->u), static_cast<double>(kept->v),
                  static_cast<double>(kept->u + kept->width), static_cast<double>(kept->v + kept->height)});
    }
    return true;
}

// First adds the halos of all letters, then the letters, so that no halo covers the previous letter of the text.
bool OverlayPainter::add_labels(const annotations::Overlay& overlay) {
    for (const bool halo : {true, false})
        for (const annotations::Label& label : overlay.labels)
            if (!add(label, halo, halo ? overlay.halo : label.ink)) return false;
    return true;
}

void OverlayPainter::build(const annotations::Overlay& overlay) {
    vertices_.clear();
    for (const annotations::Plate& back : overlay.plates) add(back);
    for (const annotations::Fill& fill : overlay.fills) add(fill);
    for (const annotations::Stroke& stroke : overlay.strokes) add(stroke, halo_width(stroke), overlay.halo);
    for (const annotations::Stroke& stroke : overlay.strokes) add(stroke, stroke.width, stroke.ink);
    for (const annotations::Triangle& triangle : overlay.triangles) add(triangle);
    const std::size_t marks = vertices_.size();
    // A full atlas grows, and all labels are added again. If it cannot grow, labels that do not fit are not drawn.
    while (!add_labels(overlay)) {
        const bool may_fit = atlas_.clear();
        vertices_.resize(marks);
        if (may_fit) continue;
        static_cast<void>(add_labels(overlay));
        break;
    }
}

void OverlayPainter::prepare(const Frame& frame) {
    vertices_.clear();
    if (!frame.annotations.empty()) build(annotations::lay_out(frame, font_));
}

void OverlayPainter::touch(TouchedTiles& touched, int height) const {
    const auto from_top = static_cast<float>(height);
    for (std::size_t i = 0; i + 3 <= vertices_.size(); i += 3) {
        const auto [left, right] = std::minmax({vertices_[i].x, vertices_[i + 1].x, vertices_[i + 2].x});
        const auto [top, bottom] = std::minmax({vertices_[i].y, vertices_[i + 1].y, vertices_[i + 2].y});
        touched.touch(left - 1, from_top - bottom - 1, right + 1, from_top - top + 1);
    }
}

void OverlayPainter::draw(const Frame& frame) {
    if (frame.annotations.empty()) return;
    gl_.BindVertexArray(array_);
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
    if (vertices_ != uploaded_) {
        gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices_.size() * sizeof(Vertex)), vertices_.data(),
                       GL_STREAM_DRAW);
        uploaded_ = vertices_;
    }
    gl_.UseProgram(program_);
    gl_.Uniform2f(viewport_, static_cast<float>(frame.width), static_cast<float>(frame.height));
    gl_.Uniform1i(glyphs_, 0);
    gl_.ActiveTexture(GL_TEXTURE0);
    atlas_.bind();
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Enable(GL_BLEND);
    gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl_.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices_.size()));
    gl_.Disable(GL_BLEND);
    gl_.Enable(GL_DEPTH_TEST);
}

} // namespace server::render
