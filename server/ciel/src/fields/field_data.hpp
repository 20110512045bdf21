// The data of a Field, for the kernel's own files (paper, sections 2.2 and 3). Mutable members are computed on demand,
// under the mutex that is declared before them or under their own lock.
#pragma once

#include "ciel/field.hpp"
#include "fields/cell_ranges.hpp"
#include "fields/gradient.hpp"
#include "fields/plane_distance.hpp"
#include "fields/sparse_array.hpp"

#include <optional>

namespace ciel {

struct Field::Data {
    std::optional<Mesh> mesh;                   // nullopt if the field was made from a topology
    std::optional<Topology> topology;           // set by begin()
    mutable ValuesView values;                  // of all vertices; if `source` is set, empty until read_all
    std::shared_ptr<const ValueSource> source;  // null if the values are in memory or computed
    std::optional<detail::PlaneDistance> plane; // if set, values are computed from it, and `values` is empty
    std::shared_ptr<const void> keep_alive;
    BlockRanges of_blocks;
    std::array<double, 2> range{};

    // The value of a local vertex is at the index Block::vertex_begin + local vertex; NaN means no value. A block's
    // values are copied at its first use. After all values, at least local_ids more entries can be read. Only one of
    // local_floats and local_doubles is used.
    detail::SparseArray<float> local_floats;
    detail::SparseArray<double> local_doubles;
    std::unique_ptr<std::atomic<bool>[]> taken; // by block: whether its values have been copied
    mutable std::array<Mutex, 16> take_in_mutex;
    std::shared_ptr<const GeometricVertices> where_extrema; // the vertices that may be extrema; null means all vertices
    double direction_length = 0;                            // length of the normal when the values are plane distances

    mutable Mutex extrema_mutex;
    mutable bool extrema_made = false;
    mutable std::vector<Index> minima, maxima; // sorted by (value, id); maxima descending
    mutable detail::CellRanges ranges;
    std::shared_ptr<CellFits> fits; // shared with other fields; null if there are none
    mutable detail::GradientCache gradients;

    // Makes the values of all vertices ready for value(). If `source` is set, reads all values and keeps them.
    void read_all() const;
    [[nodiscard]] double value_alone(Index vertex) const; // reads only this value; slower than value()
    // REQUIRES: read_all was called.
    [[nodiscard]] double value(Index vertex) const { return plane ? plane->at(vertex) : values[vertex]; }
    [[nodiscard]] bool has_doubles() const {
        if (source) return source->has_doubles();
        return plane ? plane->has_doubles() : values.has_doubles();
    }
    // A value is high if it is >= the threshold: nu for doubles, and the smallest float >= nu for floats, which gives
    // the same comparisons. If nu is NaN, the threshold is infinity, which makes every finite value low.
    [[nodiscard]] double threshold(double nu) const;
    // Returns `fits` if they belong to the positions of `cut`, else null.
    [[nodiscard]] CellFits::Data* shared_fits(const FaceMeshView& cut) const;
    [[nodiscard]] bool has_gaps(Index block) const { return of_blocks.missing[block] != 0; }
    [[nodiscard]] bool crosses(Index block, double threshold) const {
        return of_blocks.low[block] < threshold && of_blocks.high[block] >= threshold;
    }
    [[nodiscard]] ValuesView of_block(Index block) const {
        if (!taken[block].load(std::memory_order_acquire)) take_in(block);
        const std::vector<Index>& slot = topology->blocks().numbers.slot;
        const std::size_t count = slot[block + 1] - slot[block];
        if (local_doubles.get() != nullptr) return std::span<const double>(local_doubles.get() + slot[block], count);
        return std::span<const float>(local_floats.get() + slot[block], count);
    }
    void begin(const Topology& of, BlockRanges block_ranges); // call once, before anything else
    [[nodiscard]] bool is_of(const Topology& other) const { return &topology->blocks() == &other.blocks(); }
    [[nodiscard]] std::array<double, 2> range_of_blocks() const;
    void make_extrema() const; // sets minima and maxima at the first call, and calls read_all

private:
    mutable Mutex reading_all_;
    mutable std::shared_ptr<const void> all_; // owns `values` if they were read from `source`

    void take_in(Index block) const;
    template <class Value>
    void take_in(Index block, Value* local) const;
    [[nodiscard]] bool find_geometric_extrema() const;
    void find_extrema() const;
};

} // namespace ciel
