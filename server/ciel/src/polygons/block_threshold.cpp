// Thresholds block by block: neither the values nor the faces of a block are read that has only kept cells, or none.
#include "blocks/blocks.hpp"
#include "blocks/cell_loops.hpp"
#include "ciel/parallel.hpp"
#include "ciel/threshold_surface.hpp"
#include "fields/field_data.hpp"
#include "polygons/face_polygons.hpp"

#include <algorithm>
#include <array>

namespace ciel {

namespace {

// Sets the flags of a block's cells from its vertices in the range.
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
    struct Seen { // vertices of a cell in the range
        bool every = true, some = false;
    };
    template <class Local>
    void run(const PolyhedralSection<Local>& polyhedra) {
        std::size_t corners = 0; // of all cells together, which a changed record could make very many
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

// The faces inside the mesh between a kept cell and one that is not.
class InnerFaces {
public:
    struct Found {
        CellLoops loops;         // wound outwards from the kept cell
        std::vector<Index> cell; // by face: the kept cell
    };

    InnerFaces(const Topology& topology, const BlockBoxes& boxes, std::span<const std::uint8_t> kept)
        : topology_(topology), blocks_(topology.blocks()), boxes_(boxes), kept_(kept), has_(blocks_.count()) {
        parallel_for(has_.size(), 16, [this](std::size_t begin, std::size_t end) {
            for (std::size_t b = begin; b < end; ++b) {
                const auto cells =
                    kept_.subspan(blocks_.numbers.cell[b], blocks_.numbers.cell[b + 1] - blocks_.numbers.cell[b]);
                const bool some = std::ranges::any_of(cells, [](std::uint8_t flag) { return flag != 0; });
                const bool every = std::ranges::none_of(cells, [](std::uint8_t flag) { return flag == 0; });
                has_[b] = !some ? Has::none : every ? Has::all : Has::both;
            }
        });
    }

    // Calls f(found) for one block after another.
    template <class F>
    void for_blocks(F&& f) const {
        const std::vector<Index> blocks = blocks_to_read();
        constexpr std::size_t at_once = 64; // so that few results are in memory
        for (std::size_t first = 0; first < blocks.size(); first += at_once) {
            std::array<Found, at_once> found;
            parallel_for(std::min(at_once, blocks.size() - first), 1, [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i) find_in(blocks[first + i], found[i]);
            });
            std::ranges::for_each(found, f);
        }
    }

private:
    enum class Has : std::uint8_t { none, both, all }; // which kept cells a block has

    // Blocks with both kinds of cells, and those of kept cells that may have a neighbour without.
    [[nodiscard]] std::vector<Index> blocks_to_read() const {
        std::vector<Index> others; // by the low end of their box in x
        double widest = 0;
        for (Index b = 0; b < blocks_.count(); ++b) {
            if (has_[b] == Has::all) continue;
            others.push_back(b);
            widest = std::max(widest, boxes_[0].high[b] - boxes_[0].low[b]);
        }
        const auto low = [this](Index b) { return boxes_[0].low[b]; };
        std::ranges::sort(others, {}, low);
        const auto has_neighbor = [&](Index b) {
            auto other = std::ranges::lower_bound(others, boxes_[0].low[b] - widest, {}, low);
            const auto end = std::ranges::upper_bound(others, boxes_[0].high[b], {}, low);
            return std::any_of(other, end, [&](Index of) { return boxes_touch(b, of); });
        };
        std::vector<Index> found;
        for (Index b = 0; b < blocks_.count(); ++b)
            if (has_[b] == Has::both || (has_[b] == Has::all && has_neighbor(b))) found.push_back(b);
        return found;
    }
    [[nodiscard]] bool boxes_touch(Index a, Index b) const {
        return std::ranges::all_of(boxes_, [&](const BlockRanges& axis) {
            return axis.low[a] <= axis.high[b] && axis.low[b] <= axis.high[a];
        });
    }

    void find_in(Index b, Found& found) const {
        const Block& block = blocks_.cells(b);
        for (const StandardSection& section : block.standard) find_in(b, block, section, found);
        block.with([&](const auto& polyhedra) { find_in(b, block, polyhedra, found); });
    }
    void find_in(Index b, const Block& block, const StandardSection& section, Found& found) const {
        const StandardShape& shape = *section.shape;
        for (Index i = 0; i < section.count(); ++i) {
            const Index cell = block.cell(section.local_cell(i));
            if (kept_[cell] == 0) continue;
            for (std::size_t face = 0; face < shape.faces; ++face) {
                const Index first = shape.face_begin[face];
                if (!ends_at(half_edge_in(b, section.half_edge_begin + i * shape.half_edges + first))) continue;
                add_face(block, section, i, face, found.loops);
                found.cell.push_back(cell);
            }
        }
    }
    template <class Local>
    void find_in(Index b, const Block& block, const PolyhedralSection<Local>& polyhedra, Found& found) const {
        std::size_t corners = 0;
        for (Index i = 0; i < polyhedra.count(); ++i) {
            const Index cell = block.cell(polyhedra.local_cell(i));
            if (kept_[cell] == 0) continue;
            for (const Local& entry : polyhedra.faces_of(i)) {
                const Index face_and_side = read_once(entry), side = face_and_side % 2;
                const auto loop = corners_of_face(polyhedra, face_and_side / 2);
                corners += loop.size();
                if (corners > polyhedra.half_edge_count()) refuse_changed("a cell has more corners than its block");
                if (loop.size() < 3 ||
                    !ends_at(half_edge_in(b, polyhedra.half_edge_begin + polyhedra.half_edge(loop.begin, side))))
                    continue;
                add_face(block, polyhedra, loop, side, found.loops);
                found.cell.push_back(cell);
            }
        }
    }
    // Returns whether the cell on the other side of the half-edge's face exists and is not kept.
    [[nodiscard]] bool ends_at(HalfEdge h) const {
        const HalfEdge mate = topology_.mate_polyhedron(h);
        if (mate == no_half_edge) return false;
        const Has of_block = has_[block_of(mate)];
        return of_block == Has::none || (of_block == Has::both && kept_[topology_.cell(mate)] == 0);
    }

    const Topology& topology_;
    const Topology::Blocks& blocks_;
    const BlockBoxes& boxes_;
    std::span<const std::uint8_t> kept_;
    std::vector<Has> has_; // by block
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

Surface threshold_surface(const Topology& topology, const FaceMeshView& points, const BoundaryFaces& boundary,
                          const BlockBoxes& boxes, std::span<const std::uint8_t> kept) {
    const TopologyCounts& counts = topology.counts();
    if (kept.size() != counts.cells || boundary.mesh.cell_count() != counts.cells ||
        points.vertex_count() != counts.vertices || boxes[0].low.size() != topology.block_count())
        fail("a threshold's flags, boundary, positions or boxes are of another mesh than the topology");
    FacePolygons polygons(points);
    std::vector<Index> loop;
    for (Index number = 0; number < boundary.mesh.face_count(); ++number) {
        const Index owner = boundary.mesh.owner[number];
        if (kept[owner] == 0) continue;
        const Ids stored = boundary.mesh.loop(number);
        loop.assign(stored.begin(), stored.end());
        polygons.add(loop, owner, boundary.face[number]);
    }
    InnerFaces(topology, boxes, kept).for_blocks([&](const InnerFaces::Found& found) {
        for (std::size_t i = 0; i < found.cell.size(); ++i) polygons.add(found.loops.face(i), found.cell[i], none);
    });
    return std::move(polygons).take();
}

} // namespace ciel
