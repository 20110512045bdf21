#include "render/surfaces/transparent_points.hpp"

#include "render/context/pacing.hpp"
#include "render/surfaces/primitive_buffers.hpp"
#include "render/surfaces/shaders.hpp"
#include "render/surfaces/sort_by_key.hpp"

namespace server::render {

TransparentPoints::TransparentPoints(const Gl& gl)
    : gl_(gl), arrays_(make_vertex_arrays(gl, sizeof(Vertex),
                                          {{attribute_position, 3, offsetof(Vertex, position)},
                                           {attribute_scalar, 1, offsetof(Vertex, scalar)},
                                           {attribute_size, 1, offsetof(Vertex, size)},
                                           {attribute_color, 4, offsetof(Vertex, color)},
                                           {attribute_style, 2, offsetof(Vertex, style)}})) {}

void TransparentPoints::load(const std::vector<ScaledPrimitives>& all, const glm::vec4& depth_row) {
    std::vector<Held> wanted;
    wanted.reserve(all.size());
    bool same = true;
    for (const auto& [primitives, scale] : all) {
        same = same && primitives->revision != 0;
        wanted.push_back({primitives->identity, primitives->revision, primitives->color, scale, primitives->point_size,
                          primitives->lit});
    }
    same = same && wanted == held_;
    if (same && is_ordered_ && depth_row == depth_row_) return;
    is_ordered_ = false; // stays false until the upload is complete
    if (!same) {
        held_.clear();
        gather(all);
        upload_vertices();
        held_ = std::move(wanted);
    }
    depth_row_ = depth_row;
    sort();
    upload_order();
    is_ordered_ = true;
}

void TransparentPoints::gather(const std::vector<ScaledPrimitives>& all) {
    std::size_t points = 0;
    for (const auto& [primitives, scale] : all) {
        check_primitives(*primitives);
        points += primitives->indices.size();
    }
    vertices_.clear();
    vertices_.reserve(points); // once, because a reserve per element would copy all earlier ones
    for (const ScaledPrimitives& one : all) add(one);
}

void TransparentPoints::add(const ScaledPrimitives& one) {
    const Primitives& primitives = *one.primitives;
    Vertex vertex{{}, 0, primitives.point_size, primitives.color, {one.scale.row, primitives.lit ? 1.0F : 0.0F}};
    in_pieces(gl_, primitives.indices.size(), [&](std::size_t i, std::size_t end) {
        for (; i < end; ++i) {
            vertex.position = primitives.positions[primitives.indices[i]];
            if (!primitives.scalars.empty())
                vertex.scalar = static_cast<float>(primitives.scalars[primitives.indices[i]] - one.scale.origin);
            vertices_.push_back(vertex);
        }
    });
}

void TransparentPoints::upload_vertices() {
    if (vertices_.empty()) return;
    gl_.BindBuffer(GL_ARRAY_BUFFER, arrays_.vertices);
    fill_buffer(gl_, GL_ARRAY_BUFFER, vertices_.size() * sizeof(Vertex), vertices_.data());
}

void TransparentPoints::sort() {
    sorted_.resize(vertices_.size());
    in_pieces(gl_, vertices_.size(), [&](std::size_t i, std::size_t end) {
        for (; i < end; ++i) {
            const ciel::Vec3f& p = vertices_[i].position;
            const float nearness = depth_row_.x * p[0] + depth_row_.y * p[1] + depth_row_.z * p[2];
            sorted_[i] = {sortable(-nearness), static_cast<ciel::Index>(i)};
        }
    });
    sort_by_key(gl_, sorted_, other_);
}

void TransparentPoints::upload_order() {
    order_.resize(sorted_.size());
    in_pieces(gl_, sorted_.size(), [&](std::size_t i, std::size_t end) {
        for (; i < end; ++i) order_[i] = sorted_[i].vertex;
    });
    if (order_.empty()) return;
    gl_.BindVertexArray(arrays_.array);
    fill_buffer(gl_, GL_ELEMENT_ARRAY_BUFFER, order_.size() * sizeof(ciel::Index), order_.data());
}

void TransparentPoints::draw() const {
    gl_.BindVertexArray(arrays_.array);
    draw_elements(gl_, GL_POINTS, 0, order_.size());
}

} // namespace server::render
