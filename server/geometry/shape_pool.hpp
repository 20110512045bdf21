// Reuses the buffers of shapes: while a slider moves, each frame needs a surface about as large as the last surface.
#pragma once

#include "geometry/scene_geometry.hpp"

#include <mutex>

namespace server::geometry {

// Thread-safe. A shape returns to the pool when its last owner releases it. The pool keeps at most one shape.
class ShapePool : public std::enable_shared_from_this<ShapePool> {
public:
    [[nodiscard]] static std::shared_ptr<ShapePool> make() { return std::make_shared<ShapePool>(); }

    // Returns the kept shape, which still has its old contents, or an empty shape if none is kept.
    [[nodiscard]] std::shared_ptr<Shape> take();
    void forget(); // drops the kept shape
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    void give(std::unique_ptr<Shape> shape);

    mutable std::mutex mutex_;
    std::unique_ptr<Shape> kept_;
};

[[nodiscard]] std::size_t bytes_of(const Shape& shape);

} // namespace server::geometry
