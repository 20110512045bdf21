// Finds the cells whose values are in a range, and makes the surface around them, block by block. Does not read the
// values of a block whose range decides for all its cells. Does not read the faces of a block that cannot have a face
// between a kept cell and another cell.
#include "blocks/blocks.hpp"
#include "blocks/cell_loops.hpp"
#include "blocks/inner_faces.hpp"
#include "ciel/parallel.hpp"
#include "ciel/threshold_surface.hpp"
#include "fields/field_data.hpp"
#include "polygons/face_polygons.hpp"

#include <algorithm>
#include <array>
#include <atomic>

namespace ciel {

using namespace detail;

namespace {

class KeepCells {
public:
    KeepCells(const Block& block, ValuesView values, std::array<double, 2> range, InRange vertices,
              std::vector<std::uint8_t>& kept)
        : block_(block), values_(values), range_(range), all_(vertices == InRange::all), kept_(kept) {}

    void run() {
        for (const StandardSection& section : block_.standard)
            for (Index i = 0; i < section.count(); ++i) {
                Seen seen;
                for (Index k = 0; k < section.shape->corners; ++k)
                    add(section.vertex[i * section.shape->corners + k], seen);
                keep(section.local_cell(i), seen);
            }
        block_.with([this](const auto& polyhedra) { run(polyhedra); });
    }

private:
    struct Seen {
        bool every = true, some = false;
    };
    template <class Local>
    void run(const PolyhedralSection<Local>& polyhedra) {
        // The corners are counted, because a changed record may have too many.
        std::size_t corners = 0;
        for (Index i = 0; i < polyhedra.count(); ++i) {
            Seen seen;
            for (const Local& entry : polyhedra.faces_of(i)) {
                const auto loop = corners_of_face(polyhedra, Index{read_once(entry)} / 2);
                corners += loop.size();
                if (corners > polyhedra.half_edge_count()) refuse_changed("a cell has more corners than its block");
                for (Index corner = loop.begin; corner < loop.end; ++corner) add(polyhedra.vertex[corner], seen);
            }
            keep(polyhedra.local_cell(i), seen);
        }
    }
    template <class Local>
    void add(const Local& vertex, Seen& seen) const {
        const double value = values_[read_once(vertex)];
        const bool is_inside = value >= range_[0] && value <= range_[1];
        seen.every = seen.every && is_inside;
        seen.some = seen.some || is_inside;
    }
    void keep(Index local_cell, const Seen& seen) {
        kept_[block_.cell(local_cell)] = seen.some && (seen.every || !all_) ? 1 : 0;
    }

    const Block& block_;
    ValuesView values_;
    std::array<double, 2> range_;
    bool all_;
    std::vector<std::uint8_t>& kept_;
};

} // namespace

std::vector<std::uint8_t> cells_in_range(const Field& field, std::array<double, 2> range, InRange vertices) {
    const Field::Data& data = field.data();
    const Topology::Blocks& blocks = data.topology->blocks();
    const std::vector<double>&low = data.of_blocks.low, &high = data.of_blocks.high;
    std::vector<std::uint8_t> kept(data.topology->counts().cells, 0);
    parallel_for(blocks.count(), 4, [&](std::size_t begin, std::size_t end) {
        for (auto b = static_cast<Index>(begin); b < end; ++b) {
            const bool is_whole = !data.has_gaps(b);
            if (is_whole && (high[b] < range[0] || low[b] > range[1])) continue;
            if (is_whole && low[b] >= range[0] && high[b] <= range[1])
                std::fill(kept.begin() + blocks.numbers.cell[b], kept.begin() + blocks.numbers.cell[b + 1],
                          std::uint8_t{1});
            else
                KeepCells(blocks.cells(b), data.of_block(b), range, vertices, kept).run();
        }
    });
    return kept;
}

std::size_t count_cells_without_value(const Field& field, ValuesView values, bool (*counts)(double value)) {
    const Field::Data& data = field.data();
    const Topology::Blocks& blocks = data.topology->blocks();
    if (values.size() != data.topology->counts().vertices)
        fail("the number of values is not the number of vertices; pass the values from which the field was "
             "made");
    std::atomic<std::size_t> count{0};
    parallel_for(blocks.count(), 4, [&](std::size_t begin, std::size_t end) {
        CellLoops loops;
        for (auto b = static_cast<Index>(begin); b < end; ++b) {
            if (!data.has_gaps(b)) continue;
            for_cells(blocks.cells(b), loops, [&](Index, const CellLoops& of_cell) {
                count += std::ranges::any_of(of_cell.vertex, [&](Index v) { return counts(values[v]); }) ? 1 : 0;
            });
        }
    });
    return count;
}

Surface threshold_surface(const Topology& topology, const FaceMeshView& boundary, const BlockBoxes& boxes,
                          std::span<const std::uint8_t> kept, CollapsedFaces collapsed) {
    if (boundary.cell_count() != topology.counts().cells || boundary.vertex_count() != topology.counts().vertices)
        fail("the boundary of a threshold belongs to another mesh than the topology; pass the boundary of the "
             "topology's mesh");
    const InnerFaces inner(topology, boxes, kept);
    FacePolygons polygons(boundary, collapsed);
    std::vector<Index> loop;
    for (Index number = 0; number < boundary.face_count(); ++number) {
        const Index owner = boundary.owner[number];
        if (boundary.neighbour[number] != none || kept[owner] == 0) continue;
        const Ids stored = boundary.loop(number);
        loop.assign(stored.begin(), stored.end());
        polygons.add(loop, owner, number);
    }
    inner.for_blocks([&](const InnerFaces::OfBlock& found) {
        for (std::size_t i = 0; i < found.cell.size(); ++i) polygons.add(found.loops.face(i), found.cell[i], none);
    });
    return std::move(polygons).take();
}

} // namespace ciel
