// A shape's buffers, used again: a hand on a slider makes a surface per frame, each about as large as the last.
#pragma once

#include "geometry/scene_geometry.hpp"

#include <mutex>

namespace ciel::geometry {

// Any thread: a shape comes back when the last who holds it lets go, which may be a picture under way. One is kept.
class ShapePool : public std::enable_shared_from_this<ShapePool> {
public:
    [[nodiscard]] static std::shared_ptr<ShapePool> make() { return std::make_shared<ShapePool>(); }

    // Empty but for what its buffers hold.
    [[nodiscard]] std::shared_ptr<Shape> take();
    void forget(); // the one that is kept
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    void give(std::unique_ptr<Shape> shape);

    mutable std::mutex mutex_;
    std::unique_ptr<Shape> kept_;
};

[[nodiscard]] std::size_t bytes_of(const Shape& shape);

} // namespace ciel::geometry
