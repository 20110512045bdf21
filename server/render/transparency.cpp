#include "render/transparency.hpp"

#include "render/mesh_buffers.hpp"
#include "render/pacing.hpp"
#include "render/shaders.hpp"
#include "render/sort_by_key.hpp"

namespace ciel::render {

TransparentTriangles::TransparentTriangles(const Gl& gl)
    : gl_(gl), arrays_(make_vertex_arrays(gl, sizeof(Vertex),
                                          {{attribute_position, 3, offsetof(Vertex, position)},
                                           {attribute_normal, 3, offsetof(Vertex, normal)},
                                           {attribute_scalar, 1, offsetof(Vertex, scalar)},
                                           {attribute_color, 4, offsetof(Vertex, color)},
                                           {attribute_style, 2, offsetof(Vertex, style)}})) {}

void TransparentTriangles::load(const std::vector<Part>& parts, const glm::vec4& depth_row, bool sorted) {
    std::vector<Held> wanted;
    bool same = true;
    for (const auto& [mesh, scale] : parts) {
        same = same && mesh->revision != 0;
        wanted.push_back({mesh->identity, mesh->revision, mesh->color, scale, mesh->lit});
    }
    same = same && wanted == held_;
    if (same && sorted == is_sorted_ && (!sorted || depth_row == depth_row_)) return;
    if (!same) {
        held_.clear(); // until all is there
        vertices_.clear();
        triangles_.clear();
        for (const Part& part : parts) add(part);
        upload_vertices();
    }
    depth_row_ = depth_row;
    is_sorted_ = sorted;
    if (sorted)
        sort();
    else // of two in one place the first one drawn is peeled, and the other not at all: the last layer's is
        sorted_.assign(triangles_.rbegin(), triangles_.rend());
    upload_order();
    held_ = std::move(wanted);
}

void TransparentTriangles::add(const Part& part) {
    const Mesh& mesh = *part.mesh;
    const auto first = static_cast<Index>(vertices_.size());
    Vertex vertex{{}, {}, 0, mesh.color, {part.scale.row, mesh.lit ? 1.0F : 0.0F}};
    vertices_.reserve(vertices_.size() + mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        vertex.position = mesh.positions[i];
        if (!mesh.normals.empty()) vertex.normal = mesh.normals[i];
        if (!mesh.scalars.empty()) vertex.scalar = mesh.scalars[i] - part.scale.origin;
        vertices_.push_back(vertex);
    }
    triangles_.reserve(triangles_.size() + mesh.indices.size() / 3);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        triangles_.push_back({0, {first + mesh.indices[i], first + mesh.indices[i + 1], first + mesh.indices[i + 2]}});
}

void TransparentTriangles::upload_vertices() {
    if (vertices_.empty()) return;
    gl_.BindBuffer(GL_ARRAY_BUFFER, arrays_.vertices);
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices_.size() * sizeof(Vertex)), vertices_.data(),
                   GL_STREAM_DRAW);
}

void TransparentTriangles::sort() {
    const auto nearness = [&](Index corner) {
        const Vec3f& p = vertices_[corner].position;
        return depth_row_.x * p[0] + depth_row_.y * p[1] + depth_row_.z * p[2];
    };
    for (Triangle& triangle : triangles_) {
        const auto [a, b, c] = triangle.corners;
        triangle.key = sortable(nearness(a) + nearness(b) + nearness(c));
    }
    sorted_ = triangles_;
    sort_by_key(sorted_, other_);
}

void TransparentTriangles::upload_order() {
    indices_.clear();
    indices_.reserve(3 * sorted_.size());
    for (const Triangle& triangle : sorted_)
        indices_.insert(indices_.end(), triangle.corners.begin(), triangle.corners.end());
    if (indices_.empty()) return;
    gl_.BindVertexArray(arrays_.array);
    gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices_.size() * sizeof(Index)), indices_.data(),
                   GL_STREAM_DRAW);
}

void TransparentTriangles::draw() const {
    gl_.BindVertexArray(arrays_.array);
    draw_elements(gl_, GL_TRIANGLES, 0, indices_.size());
}

} // namespace ciel::render
