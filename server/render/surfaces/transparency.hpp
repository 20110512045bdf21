// The transparent triangles of a frame: unsorted for depth_peeling.hpp, or sorted from back to front by their centers.
// The sorted order is correct where triangles do not cross or enclose each other.
#pragma once

#include "render/context/gl.hpp"
#include "render/context/vertex_arrays.hpp"
#include "render/frame/frame.hpp"
#include "render/surfaces/color_scales.hpp"

#include <glm/vec4.hpp>
#include <vector>

namespace server::render {

class TransparentTriangles {
public:
    explicit TransparentTriangles(const Gl& gl);

    // Uploads only what has changed. depth_row: the row of the view matrix that gives -depth, so larger values are
    // nearer. `sorted`: sorts from far to near. If cancelling (pacing.hpp) interrupts an upload, load() again before
    // draw().
    void load(const std::vector<ScaledPrimitives>& all, const glm::vec4& depth_row, bool sorted);
    [[nodiscard]] bool is_empty() const { return triangles_.empty(); }
    void draw() const;

private:
    struct Vertex {
        ciel::Vec3f position, normal;
        float scalar;
        std::array<float, 4> color;
        std::array<float, 2> style;
    };
    struct Triangle {
        std::uint32_t key; // larger is nearer
        std::array<ciel::Index, 3> corners;
    };
    struct Held { // properties of primitives on which their uploaded vertices depend
        std::uint64_t identity, revision;
        std::array<float, 4> color;
        ScaleRow scale;
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
    bool is_sorted_ = false, is_ordered_ = false; // is_ordered_: the uploaded order fits depth_row_ and is_sorted_
    std::vector<Held> held_;
    std::vector<Vertex> vertices_;
    std::vector<Triangle> triangles_; // in the order of Frame::primitives, which decides the order of equal depths
    std::vector<Triangle> sorted_;    // in draw order
    std::vector<Triangle> other_;
    std::vector<ciel::Index> indices_;
};

} // namespace server::render
