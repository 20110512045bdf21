// Gradients of a scalar field (paper, section 3): least squares per polyhedron, averaged at the vertices by volume.
// Departures from the paper: centred 3 x 3 normal equations in double instead of 4 x 4 in float, which lose everything
// far from the origin; and only where somebody asks.
#pragma once

#include "ciel/blocks.hpp"
#include "ciel/field.hpp"
#include "ciel/threads.hpp"

namespace ciel {

struct EdgePoint;

// One cell's gradient and weight from its distinct vertices and its loops. Scratch for many cells.
class CellGradient {
public:
    struct Result {
        Vec3f gradient{};
        float volume = 0; // 0: the cell spans nothing, or lacks a value, and does not count
    };
    void clear();
    Index add_vertex(const float* position, float value);
    void add_corner(Index vertex) { corners_.push_back(vertex); }
    void end_loop(bool reversed);
    [[nodiscard]] Result solve();

private:
    struct Sample {
        double x, y, z, value;
    };
    struct Loop {
        std::size_t end;
        bool reversed;
    };
    [[nodiscard]] double volume() const;

    std::vector<Sample> samples_;
    std::vector<Index> corners_;
    std::vector<Loop> loops_;
};

// Thread-safe. All calls must pass the same topology, field and positions.
class GradientCache {
public:
    // Makes the gradients at both ends of the points. The result is by mesh vertex and holds only what was ever asked
    // for; it stays valid while the cache lives.
    std::span<const Vec3f> at(const FaceMeshView& mesh, const Field::Blocks& field, std::span<const EdgePoint> points);
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    void make_cells(const FaceMeshView& mesh, const Field::Blocks& field);
    void average(std::span<const Index> vertices, std::span<const Index> cells, std::span<const Index> cell_end);

    mutable Mutex mutex_;
    std::vector<Vec3f> gradient_;            // by vertex
    std::vector<std::uint8_t> vertex_known_; // by vertex
    std::vector<CellGradient::Result> cell_; // by cell
    std::vector<std::uint8_t> cell_state_;   // by cell: 0 unknown, 1 wanted, 2 known
};

} // namespace ciel
