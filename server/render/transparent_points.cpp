#include "render/transparent_points.hpp"

#include "render/mesh_buffers.hpp"
#include "render/pacing.hpp"
#include "render/shaders.hpp"
#include "render/sort_by_key.hpp"

namespace ciel::render {

TransparentPoints::TransparentPoints(const Gl& gl)
    : gl_(gl), arrays_(make_vertex_arrays(gl, sizeof(Vertex),
                                          {{attribute_position, 3, offsetof(Vertex, position)},
                                           {attribute_scalar, 1, offsetof(Vertex, scalar)},
                                           {attribute_size, 1, offsetof(Vertex, size)},
                                           {attribute_color, 4, offsetof(Vertex, color)},
                                           {attribute_style, 2, offsetof(Vertex, style)}})) {}

void TransparentPoints::load(const std::vector<Part>& parts, const glm::vec4& depth_row) {
    std::vector<Held> wanted;
    bool same = true;
    for (const auto& [mesh, scale] : parts) {
        same = same && mesh->revision != 0;
        wanted.push_back({mesh->identity, mesh->revision, mesh->color, scale, mesh->point_size, mesh->lit});
    }
    same = same && wanted == held_;
    if (same && depth_row == depth_row_) return;
    if (!same) {
        held_.clear(); // until all is there
        vertices_.clear();
        for (const Part& part : parts) add(part);
        upload_vertices();
    }
    depth_row_ = depth_row;
    upload_order();
    held_ = std::move(wanted);
}

void TransparentPoints::add(const Part& part) {
    const Mesh& mesh = *part.mesh;
    check_mesh(mesh);
    Vertex vertex{{}, 0, mesh.point_size, mesh.color, {part.scale.row, mesh.lit ? 1.0F : 0.0F}};
    vertices_.reserve(vertices_.size() + mesh.indices.size());
    for (const Index i : mesh.indices) {
        vertex.position = mesh.positions[i];
        if (!mesh.scalars.empty()) vertex.scalar = mesh.scalars[i] - part.scale.origin;
        vertices_.push_back(vertex);
    }
}

void TransparentPoints::upload_vertices() {
    if (vertices_.empty()) return;
    gl_.BindBuffer(GL_ARRAY_BUFFER, arrays_.vertices);
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices_.size() * sizeof(Vertex)), vertices_.data(),
                   GL_STREAM_DRAW);
}

void TransparentPoints::upload_order() {
    sorted_.clear();
    sorted_.reserve(vertices_.size());
    for (const Vertex& vertex : vertices_) {
        const Vec3f& p = vertex.position;
        const float nearness = depth_row_.x * p[0] + depth_row_.y * p[1] + depth_row_.z * p[2];
        sorted_.push_back({sortable(-nearness), static_cast<Index>(sorted_.size())});
    }
    sort_by_key(sorted_, other_);
    order_.clear();
    for (const Point& point : sorted_) order_.push_back(point.vertex);
    if (order_.empty()) return;
    gl_.BindVertexArray(arrays_.array);
    gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(order_.size() * sizeof(Index)), order_.data(),
                   GL_STREAM_DRAW);
}

void TransparentPoints::draw() const {
    gl_.BindVertexArray(arrays_.array);
    draw_elements(gl_, GL_POINTS, 0, order_.size());
}

} // namespace ciel::render
