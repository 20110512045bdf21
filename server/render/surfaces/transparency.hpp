// Transparent triangles of all layers in one buffer; in any order for depth_peeling.hpp, or sorted from the back to the
// front by their centres' depth: the plain method. Right wherever triangles do not cross or enclose each other; the
// layers may cross as they like.
#pragma once

#include "render/context/gl.hpp"
#include "render/context/vertex_arrays.hpp"
#include "render/frame/frame.hpp"
#include "render/surfaces/color_scales.hpp"

#include <glm/vec4.hpp>
#include <vector>

namespace ciel::render {

class TransparentTriangles {
public:
    explicit TransparentTriangles(const Gl& gl);

    // depth_row: the row of the view matrix that gives -depth, so that more is nearer. `sorted`: from far to near, by
    // it. Vertices are uploaded where a part has changed, and their order where that or what it follows has. Can be
    // given up between pieces (pacing.hpp); then load() again before anything is drawn.
    void load(const std::vector<ScaledPrimitives>& parts, const glm::vec4& depth_row, bool sorted);
    [[nodiscard]] bool is_empty() const { return triangles_.empty(); }
    void draw() const;

private:
    struct Vertex {
        Vec3f position, normal;
        float scalar;
        std::array<float, 4> color;
        std::array<float, 2> style;
    };
    struct Triangle {
        std::uint32_t key; // grows with nearness
        std::array<Index, 3> corners;
    };
    struct Held { // of a part: what its vertices depend on
        std::uint64_t identity, revision;
        std::array<float, 4> color;
        ScaleRow scale;
        bool lit;
        bool operator==(const Held&) const = default;
    };
    void gather(const std::vector<ScaledPrimitives>& parts);
    void add(const ScaledPrimitives& part);
    void upload_vertices();
    void sort();
    void upload_order();

    const Gl& gl_;
    VertexArrays arrays_;
    glm::vec4 depth_row_{};
    bool is_sorted_ = false, is_ordered_ = false; // the order of depth_row_ and is_sorted_ is on the GL's side
    std::vector<Held> held_;
    std::vector<Vertex> vertices_;
    std::vector<Triangle> triangles_; // in the order of the parts: ties are drawn in it, whatever was drawn before
    std::vector<Triangle> sorted_;    // as they are drawn
    std::vector<Triangle> other_;
    std::vector<Index> indices_;
};

} // namespace ciel::render
