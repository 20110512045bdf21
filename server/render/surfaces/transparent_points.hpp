// Transparent points of all layers in one buffer, from the nearest to the farthest: a disc that faces the viewer is as
// deep as its centre all over, so this order is right at every pixel.
#pragma once

#include "render/context/gl.hpp"
#include "render/context/vertex_arrays.hpp"
#include "render/frame/frame.hpp"
#include "render/surfaces/color_scales.hpp"

#include <glm/vec4.hpp>
#include <vector>

namespace ciel::render {

// Its GL objects live as long as their context.
class TransparentPoints {
public:
    explicit TransparentPoints(const Gl& gl);

    // depth_row: the row of the view matrix that gives -depth. Vertices are uploaded where a part has changed, and
    // their order where that or what it follows has. Can be given up between pieces (pacing.hpp); then load() again
    // before anything is drawn. Throws Error when arrays of a mesh do not fit together.
    void load(const std::vector<ScaledPrimitives>& parts, const glm::vec4& depth_row);
    [[nodiscard]] bool is_empty() const { return order_.empty(); }
    void draw() const;

private:
    struct Vertex {
        Vec3f position;
        float scalar, size;
        std::array<float, 4> color;
        std::array<float, 2> style;
    };
    struct Point {
        std::uint32_t key; // grows with the distance
        Index vertex;
    };
    struct Held { // of a part: what its vertices depend on
        std::uint64_t identity, revision;
        std::array<float, 4> color;
        ScaleRow scale;
        float size;
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
    bool is_ordered_ = false; // the order of depth_row_ is on the GL's side
    std::vector<Held> held_;
    std::vector<Vertex> vertices_; // one a point, in the order of the parts: ties are drawn in it
    std::vector<Point> sorted_, other_;
    std::vector<Index> order_;
};

} // namespace ciel::render
