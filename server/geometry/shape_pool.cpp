#include "geometry/shape_pool.hpp"

namespace server::geometry {

std::size_t bytes_of(const Shape& shape) {
    const ciel::Surface& s = shape.surface;
    return (s.positions.capacity() + s.normals.capacity()) * sizeof(ciel::Vec3f) +
           s.points.capacity() * sizeof(ciel::EdgePoint) +
           (s.polygon_offset.capacity() + s.polygon_vertex.capacity() + s.polygon_cell.capacity() +
            s.polygon_face.capacity() + shape.indices.capacity()) *
               sizeof(ciel::Index);
}

std::shared_ptr<Shape> ShapePool::take() {
    std::unique_ptr<Shape> shape;
    {
        const std::lock_guard lock(mutex_);
        shape = std::move(kept_);
    }
    if (!shape) shape = std::make_unique<Shape>();
    return {shape.release(), [pool = shared_from_this()](Shape* back) { pool->give(std::unique_ptr<Shape>(back)); }};
}

void ShapePool::give(std::unique_ptr<Shape> shape) {
    const std::lock_guard lock(mutex_);
    if (!kept_) kept_ = std::move(shape);
}

void ShapePool::forget() {
    const std::lock_guard lock(mutex_);
    kept_ = nullptr;
}

std::size_t ShapePool::memory_bytes() const {
    const std::lock_guard lock(mutex_);
    return kept_ ? bytes_of(*kept_) : 0;
}

} // namespace server::geometry
