// The set of tiles of a picture on which a frame draws. Other tiles need not be cleared, read and converted.
#pragma once

#include "annotations/camera.hpp"
#include "render/frame/frame.hpp"

#include <vector>

namespace server::render {

// Box in pixels from the lower left, as OpenGL counts them.
struct PixelBox {
    int left, bottom, width, height;
};

class TouchedTiles {
public:
    static constexpr int side = 64; // pixels per side of a tile; llvmpipe's tiles have the same size

    TouchedTiles() = default;
    TouchedTiles(int width, int height); // no tile is touched

    void touch_all();
    // The box is in pixels from the lower left. Marks all tiles if a side is not finite.
    void touch(float left, float bottom, float right, float top);
    // Marks all tiles if a vertex is behind the near plane or not finite.
    void touch(const Primitives& primitives, const annotations::ViewTransform& transform);

    [[nodiscard]] double share() const; // number of touched tiles / number of all tiles
    [[nodiscard]] bool at(int column, int row) const { return tiles_[index(column, row)] != 0; }
    // Returns boxes that cover the touched tiles, without the tiles that are touched in `except`. Consecutive rows with
    // the same tiles are in the same boxes.
    [[nodiscard]] std::vector<PixelBox> boxes(const TouchedTiles* except = nullptr) const;

private:
    [[nodiscard]] std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
    }

    int width_ = 0, height_ = 0, columns_ = 0, rows_ = 0;
    std::vector<std::uint8_t> tiles_; // 1 where touched
};

} // namespace server::render
