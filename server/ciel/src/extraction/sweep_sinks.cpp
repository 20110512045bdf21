#include "ciel/sweep_sinks.hpp"

#include "ciel/sink_pieces.hpp"
#include "extraction/edge_points.hpp"

#include <algorithm>

namespace ciel {

namespace {

std::size_t triangle_count(const BlockPolygons& cut) { return cut.polygon_point.size() - 2 * cut.polygon_count(); }

template <class F>
void for_triangles(const BlockPolygons& cut, F&& f) {
    const Index* point = cut.polygon_point.data();
    Index begin = 0;
    for (const Index end : cut.polygon_end) {
        for (Index k = begin + 2; k < end; ++k) f(point[begin], point[k - 1], point[k]);
        begin = end;
    }
}

} // namespace

void SliceSink::check(const TopologyCounts& counts) const {
    require_size(property.size(), counts.vertices, "values, one for each vertex");
}

void SliceSink::write(const BlockPolygons& cut, Piece& piece) const {
    piece.positions.assign(cut.positions.begin(), cut.positions.end());
    piece.property.resize(cut.points.size());
    std::ranges::transform(cut.points, piece.property.begin(), [this](const EdgePoint& point) {
        return lerp(property[point.a], property[point.b], point.t);
    });
    piece.triangles.resize(3 * triangle_count(cut));
    Index* to = piece.triangles.data();
    for_triangles(cut, [&](Index a, Index b, Index c) {
        to[0] = a;
        to[1] = b;
        to[2] = c;
        to += 3;
    });
}

void SliceSink::join(std::span<const Piece* const> pieces, Out& out) const {
    join_arrays(pieces, &Piece::positions, out);
    join_arrays(pieces, &Piece::property, out);
    join_triangles(pieces, &Piece::positions, out);
}

void SoupSink::write(const BlockPolygons& cut, Piece& piece) const {
    piece.resize(3 * triangle_count(cut));
    Vec3f* to = piece.data();
    const Vec3f* position = cut.positions.data();
    for_triangles(cut, [&](Index a, Index b, Index c) {
        to[0] = position[a];
        to[1] = position[b];
        to[2] = position[c];
        to += 3;
    });
}

void SoupSink::join(std::span<const Piece* const> pieces, Out& out) const { join_arrays(pieces, std::identity(), out); }

void OutlineSink::write(const BlockPolygons& cut, Piece& piece) const {
    piece.clear();
    piece.reserve(2 * cut.polygon_point.size());
    for (std::size_t i = 0; i < cut.polygon_count(); ++i) {
        Index before = cut.polygon(i).back();
        for (const Index p : cut.polygon(i)) {
            piece.push_back(cut.positions[before]);
            piece.push_back(cut.positions[p]);
            before = p;
        }
    }
}

void OutlineSink::join(std::span<const Piece* const> pieces, Out& out) const {
    join_arrays(pieces, std::identity(), out);
}

} // namespace ciel
