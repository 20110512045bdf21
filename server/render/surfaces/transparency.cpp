#include "render/surfaces/transparency.hpp"

#include "render/context/pacing.hpp"
#include "render/surfaces/primitive_buffers.hpp"
#include "render/surfaces/shaders.hpp"
#include "render/surfaces/sort_by_key.hpp"

#include <algorithm>

namespace server::render {

TransparentTriangles::TransparentTriangles(const Gl& gl)
    : gl_(gl), arrays_(make_vertex_arrays(gl, sizeof(Vertex),
                                          {{attribute_position, 3, offsetof(Vertex, position)},
                                           {attribute_normal, 3, offsetof(Vertex, normal)},
                                           {attribute_scalar, 1, offsetof(Vertex, scalar)},
                                           {attribute_color, 4, offsetof(Vertex, color)},
                                           {attribute_style, 2, offsetof(Vertex, style)}})) {}

void TransparentTriangles::load(const std::vector<ScaledPrimitives>& all, const glm::vec4& depth_row, bool sorted) {
    std::vector<Held> wanted;
    wanted.reserve(all.size());
    bool same = true;
    for (const auto& [primitives, scale] : all) {
        same = same && primitives->revision != 0;
        wanted.push_back({primitives->identity, primitives->revision, primitives->color, scale, primitives->lit});
    }
    same = same && wanted == held_;
    if (same && is_ordered_ && sorted == is_sorted_ && (!sorted || depth_row == depth_row_)) return;
    is_ordered_ = false; // stays false until the upload is complete
    if (!same) {
        held_.clear();
        gather(all);
        upload_vertices();
        held_ = std::move(wanted);
    }
    depth_row_ = depth_row;
    is_sorted_ = sorted;
    // Peeling keeps the first of coincident triangles. It must belong to the last primitives, so the order is reversed.
    if (sorted)
        sort();
    else
        sorted_.assign(triangles_.rbegin(), triangles_.rend());
    upload_order();
    is_ordered_ = true;
}

void TransparentTriangles::gather(const std::vector<ScaledPrimitives>& all) {
    std::size_t vertices = 0, triangles = 0;
    for (const auto& [primitives, scale] : all) {
        vertices += primitives->positions.size();
        triangles += primitives->indices.size() / 3;
    }
    vertices_.clear();
    triangles_.clear();
    vertices_.reserve(vertices); // once, because a reserve per element would copy all earlier ones
    triangles_.reserve(triangles);
    for (const ScaledPrimitives& one : all) add(one);
}

void TransparentTriangles::add(const ScaledPrimitives& one) {
    const Primitives& primitives = *one.primitives;
    const auto first = static_cast<ciel::Index>(vertices_.size());
    Vertex vertex{{}, {}, 0, primitives.color, {one.scale.row, primitives.lit ? 1.0F : 0.0F}};
    in_pieces(gl_, primitives.positions.size(), [&](std::size_t i, std::size_t end) {
        for (; i < end; ++i) {
            vertex.position = primitives.positions[i];
            if (!primitives.normals.empty()) vertex.normal = primitives.normals[i];
            if (!primitives.scalars.empty())
                vertex.scalar = static_cast<float>(primitives.scalars[i] - one.scale.origin);
            vertices_.push_back(vertex);
        }
    });
    const auto corner = [&](std::size_t i) { return first + primitives.indices[i]; };
    in_pieces(gl_, primitives.indices.size() / 3, [&](std::size_t i, std::size_t end) {
        for (; i < end; ++i) triangles_.push_back({0, {corner(3 * i), corner(3 * i + 1), corner(3 * i + 2)}});
    });
}

void TransparentTriangles::upload_vertices() {
    if (vertices_.empty()) return;
    gl_.BindBuffer(GL_ARRAY_BUFFER, arrays_.vertices);
    fill_buffer(gl_, GL_ARRAY_BUFFER, vertices_.size() * sizeof(Vertex), vertices_.data());
}

void TransparentTriangles::sort() {
    const auto nearness = [&](ciel::Index corner) {
        const ciel::Vec3f& p = vertices_[corner].position;
        return depth_row_.x * p[0] + depth_row_.y * p[1] + depth_row_.z * p[2];
    };
    sorted_.resize(triangles_.size());
    in_pieces(gl_, triangles_.size(), [&](std::size_t i, std::size_t end) {
        for (; i < end; ++i) {
            const auto [a, b, c] = triangles_[i].corners;
            sorted_[i] = {sortable(nearness(a) + nearness(b) + nearness(c)), {a, b, c}};
        }
    });
    sort_by_key(gl_, sorted_, other_);
}

void TransparentTriangles::upload_order() {
    indices_.resize(3 * sorted_.size());
    in_pieces(gl_, sorted_.size(), [&](std::size_t i, std::size_t end) {
        for (; i < end; ++i) std::ranges::copy(sorted_[i].corners, &indices_[3 * i]);
    });
    if (indices_.empty()) return;
    gl_.BindVertexArray(arrays_.array);
    fill_buffer(gl_, GL_ELEMENT_ARRAY_BUFFER, indices_.size() * sizeof(ciel::Index), indices_.data());
}

void TransparentTriangles::draw() const {
    gl_.BindVertexArray(arrays_.array);
    draw_elements(gl_, GL_TRIANGLES, 0, indices_.size());
}

} // namespace server::render
