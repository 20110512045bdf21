// Transparent triangles of all layers in one buffer; in any order for depth_peeling.hpp, or sorted from the back to the
// front by their centres' depth: the plain method. Right wherever triangles do not cross or enclose each other; the
// layers may cross as they like.
#pragma once

#include "render/gl.hpp"
#include "render/renderer.hpp"

#include <glm/vec4.hpp>
#include <vector>

namespace ciel::render {

class TransparentTriangles {
public:
    explicit TransparentTriangles(const Gl& gl);

    // depth_row: the row of the view matrix that gives -depth, so that more is nearer.
    void begin(const glm::vec4& depth_row);
    void add(const Mesh& mesh, float scale_row);
    void sort();
    void upload();
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

    const Gl& gl_;
    GLuint array_ = 0, vertex_buffer_ = 0, index_buffer_ = 0;
    glm::vec4 depth_row_{};
    std::vector<Vertex> vertices_;
    std::vector<Triangle> triangles_, other_;
    std::vector<Index> indices_;
};

} // namespace ciel::render
