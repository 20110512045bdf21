// The transparent points of a frame in one buffer, sorted from near to far. A point is a disc that faces the viewer,
// and all its pixels have the depth of its center. Therefore this order is correct at every pixel.
#pragma once

#include "render/context/gl.hpp"
#include "render/context/vertex_arrays.hpp"
#include "render/frame/frame.hpp"
#include "render/surfaces/color_scales.hpp"

#include <glm/vec4.hpp>
#include <vector>

namespace server::render {

// The GL objects exist until the GL context is destroyed.
class TransparentPoints {
public:
    explicit TransparentPoints(const Gl& gl);

    // Uploads only what has changed. depth_row: the row of the view matrix that gives -depth. Throws the errors of
    // check_primitives(). If cancelling (pacing.hpp) interrupts an upload, call load() again before draw().
    void load(const std::vector<ScaledPrimitives>& all, const glm::vec4& depth_row);
    [[nodiscard]] bool is_empty() const { return order_.empty(); }
    void draw() const;

private:
    struct Vertex {
        ciel::Vec3f position;
        float scalar, size;
        std::array<float, 4> color;
        std::array<float, 2> style;
    };
    struct Point {
        std::uint32_t key; // larger is farther
        ciel::Index vertex;
    };
    struct Held { // properties of primitives on which their uploaded vertices depend
        std::uint64_t identity, revision;
        std::array<float, 4> color;
        ScaleRow scale;
        float size;
        bool lit;
        bool operator==(const Held&) const = default;
    };
    void gather(const std::vector<ScaledPrimitives>& all);
    void add(const ScaledPrimitives& one);
    void upload_vertices();
    void sort();
    void upload_order();

    const Gl& gl_;
    VertexArrays arrays_;
    glm::vec4 depth_row_{};
    bool is_ordered_ = false; // true: the uploaded order fits depth_row_
    std::vector<Held> held_;
    std::vector<Vertex>
        vertices_; // one per point, in the order of Frame::primitives, which decides the order of equal depths
    std::vector<Point> sorted_, other_;
    std::vector<ciel::Index> order_;
};

} // namespace server::render
