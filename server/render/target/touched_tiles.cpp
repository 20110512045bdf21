#include "render/target/touched_tiles.hpp"

#include "render/frame/frame_properties.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/mat4x4.hpp>

namespace server::render {
namespace {

struct Span { // range of tile indices, both ends included
    std::uint16_t left, bottom, right, top;
};

Span joined(const Span& a, const Span& b) {
    return {std::min(a.left, b.left), std::min(a.bottom, b.bottom), std::max(a.right, b.right), std::max(a.top, b.top)};
}

// Projects vertices, and finds the tiles within `reach` pixels of each vertex.
class Spans {
public:
    Spans(const annotations::ViewTransform& transform, int width, int height, float reach)
        : matrix_(transform.projection * transform.view), half_width_(static_cast<float>(width) / 2),
          half_height_(static_cast<float>(height) / 2), most_x_(static_cast<float>(width - 1)),
          most_y_(static_cast<float>(height - 1)), reach_(reach) {}

    bool find(const ciel::Vec3f& position, Span& span) const {
        const glm::vec4 place = matrix_ * glm::vec4(position[0], position[1], position[2], 1);
        if (!(place.w > 0) || !(place.z >= -place.w)) return false;
        const float x = (place.x / place.w + 1) * half_width_, y = (place.y / place.w + 1) * half_height_;
        if (!std::isfinite(x) || !std::isfinite(y)) return false;
        span = {tile_of(x - reach_, most_x_), tile_of(y - reach_, most_y_), tile_of(x + reach_, most_x_),
                tile_of(y + reach_, most_y_)};
        return true;
    }

    // Calls function(span) for short pieces of a line: a slanted line touches few tiles of its bounding box `whole`.
    template <class Function>
    void for_pieces(const ciel::Vec3f& from, const ciel::Vec3f& to, const Span& whole, const Function& function) const {
        const int pieces = 2 * (whole.right - whole.left + whole.top - whole.bottom);
        Span last{}, next{};
        if (!find(from, last)) return function(whole);
        for (int i = 1; i <= pieces; ++i, last = next) {
            const float share = static_cast<float>(i) / static_cast<float>(pieces);
            if (!find({from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1]),
                       from[2] + share * (to[2] - from[2])},
                      next))
                return function(whole);
            function(joined(last, next));
        }
    }

private:
    static std::uint16_t tile_of(float pixel, float most) {
        return static_cast<std::uint16_t>(static_cast<int>(std::clamp(pixel, 0.0F, most)) / TouchedTiles::side);
    }
    glm::mat4 matrix_;
    float half_width_, half_height_, most_x_, most_y_, reach_;
};

// Returns how far a primitive extends beyond its vertices, in pixels, with a margin for rounding.
float reach_of(const Primitives& primitives) {
    if (primitives.points) return primitives.point_size / 2 + 2;
    return primitives.lines ? primitives.line_width + 2 : 1;
}

} // namespace

TouchedTiles::TouchedTiles(int width, int height)
    : width_(width), height_(height), columns_((width + side - 1) / side), rows_((height + side - 1) / side),
      tiles_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

void TouchedTiles::touch_all() { std::ranges::fill(tiles_, 1); }

void TouchedTiles::touch(float left, float bottom, float right, float top) {
    if (!std::isfinite(left + bottom + right + top)) return touch_all();
    const auto tile = [](float pixel, int last) {
        return static_cast<int>(std::clamp(std::floor(pixel / side), 0.0F, static_cast<float>(last)));
    };
    const int last_column = tile(right, columns_ - 1);
    const int last_row = tile(top, rows_ - 1);
    for (int row = tile(bottom, rows_ - 1); row <= last_row; ++row)
        for (int column = tile(left, columns_ - 1); column <= last_column; ++column) tiles_[index(column, row)] = 1;
}

void TouchedTiles::touch(const Primitives& primitives, const annotations::ViewTransform& transform) {
    const Spans spans(transform, width_, height_, reach_of(primitives));
    std::vector<Span> of_vertices(primitives.positions.size());
    for (std::size_t i = 0; i < of_vertices.size(); ++i)
        if (!spans.find(primitives.positions[i], of_vertices[i])) return touch_all();
    const std::size_t corners = corners_of(primitives);
    const auto touch_span = [&](const Span& span) {
        for (int row = span.bottom; row <= span.top; ++row)
            for (int column = span.left; column <= span.right; ++column) tiles_[index(column, row)] = 1;
    };
    for (std::size_t i = 0; i + corners <= primitives.indices.size(); i += corners) {
        Span all = of_vertices[primitives.indices[i]];
        for (std::size_t k = 1; k < corners; ++k) all = joined(all, of_vertices[primitives.indices[i + k]]);
        if (primitives.lines && all.right > all.left && all.top > all.bottom)
            spans.for_pieces(primitives.positions[primitives.indices[i]],
                             primitives.positions[primitives.indices[i + 1]], all, touch_span);
        else
            touch_span(all);
    }
}

double TouchedTiles::share() const {
    if (tiles_.empty()) return 1;
    return static_cast<double>(std::ranges::count(tiles_, 1)) / static_cast<double>(tiles_.size());
}

std::vector<PixelBox> TouchedTiles::boxes(const TouchedTiles* except) const {
    const auto wanted = [&](int column, int row) {
        return at(column, row) && (except == nullptr || !except->at(column, row));
    };
    const auto alike = [&](int row, int other) {
        for (int column = 0; column < columns_; ++column)
            if (wanted(column, row) != wanted(column, other)) return false;
        return true;
    };
    std::vector<PixelBox> found;
    for (int row = 0, next = 0; row < rows_; row = next) {
        for (next = row + 1; next < rows_ && alike(row, next);) ++next;
        const int bottom = row * side;
        const int height = std::min(next * side, height_) - bottom;
        for (int column = 0; column < columns_; ++column) {
            if (!wanted(column, row)) continue;
            const int first = column;
            while (column < columns_ && wanted(column, row)) ++column;
            const int left = first * side;
            found.push_back({left, bottom, std::min(column * side, width_) - left, height});
        }
    }
    return found;
}

} // namespace server::render
