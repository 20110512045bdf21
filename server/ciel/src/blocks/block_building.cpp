#include "blocks/block_building.hpp"

#include "blocks/block_linker.hpp"
#include "blocks/block_tables.hpp"
#include "ciel/parallel.hpp"
#include "ciel/threads.hpp"
#include "mesh/face_mesh_source.hpp"
#include "mesh/matched_cells_source.hpp"
#include "mesh/standard_shapes.hpp"

#include <algorithm>
#include <atomic>
#include <map>
#include <numeric>
#include <utility>

namespace ciel {

namespace detail {

namespace {

// Returns the first cell of each block, then the number of cells. A block gets fewer than `cells_per_block` cells if
// its local ids might not fit 16 bits (BlockBuilder::fits_16_bits). `room` limits its half-edges, where those of
// standard cells count twice; `corner_room` limits the corners of its faces. Only a single giant cell may exceed them.
template <class Source>
std::vector<Index> divide(const Source& source, Index cells_per_block) {
    constexpr std::uint64_t room = 96000, corner_room = 64000;
    std::vector<Index> begin{0};
    std::uint64_t used = 0, corners = 0; // corners: each face counted once
    for (Index cell = 0; cell < source.cell_count(); ++cell) {
        std::uint64_t of_cell = 0, new_corners = 0;
        std::size_t count = 0, largest = 0;
        source.for_faces_of(cell, [&, first = begin.back()](std::size_t size, Index owner) {
            of_cell += size;
            largest = std::max(largest, size);
            ++count;
            if (owner == cell || owner < first) new_corners += size;
        });
        const bool standard = type_of_faces(count, of_cell, largest) != CellType::polyhedron;
        const std::uint64_t room_of_cell = standard ? 2 * of_cell : of_cell;
        used += room_of_cell;
        corners += new_corners;
        if (cell > begin.back() && (cell - begin.back() == cells_per_block || used > room || corners > corner_room)) {
            begin.push_back(cell);
            used = room_of_cell;
            corners = of_cell;
        }
    }
    if (source.cell_count() > 0) begin.push_back(source.cell_count());
    return begin;
}

struct Survey {
    std::vector<Index> last_cell; // by vertex: the last cell with a face that has the vertex
    std::uint64_t boundary_faces = 0, components = 0;
};

template <class Source>
Survey survey(const Source& source) {
    Survey found;
    found.last_cell.assign(source.vertex_count(), 0);
    found.components = source.cell_count();
    std::vector<Index> parent(source.cell_count());
    std::iota(parent.begin(), parent.end(), Index{0});
    const auto root = [&](Index c) {
        while (parent[c] != c) c = parent[c] = parent[parent[c]];
        return c;
    };
    source.for_faces([&](Index owner, Index neighbour, std::span<const Index> vertices) {
        const Index last = neighbour == none ? owner : neighbour;
        if (owner >= parent.size() || last >= parent.size()) source.refuse();
        for (const Index& entry : vertices) {
            const Index vertex = read_once(entry);
            if (vertex >= found.last_cell.size()) source.refuse();
            if (found.last_cell[vertex] < last) found.last_cell[vertex] = last;
        }
        if (neighbour == none) {
            ++found.boundary_faces;
            return;
        }
        const Index a = root(owner), b = root(neighbour);
        if (a == b) return;
        parent[std::max(a, b)] = std::min(a, b);
        --found.components;
    });
    return found;
}

// Builds the blocks in parallel, and links each one when all earlier ones are linked.
class Building {
public:
    Building(const FaceSource& source, std::span<const Index> cell_begin, BlockLinker& linker, RecordSink& sink)
        : source_(source), cell_begin_(cell_begin), linker_(linker), sink_(sink), built_(cell_begin.size() - 1) {}

    void run() {
        parallel_for(thread_count(), 1, [this](std::size_t begin, std::size_t end) {
            for (; begin < end; ++begin) build_until_none_is_left();
        });
    }

private:
    struct Linked {
        std::size_t place; // index of the record in the order in which the sink gets the records
        BlockLinker::CompleteRecord record;
    };
    struct Made {
        Index block;
        RecordKind kind;
        RecordBytes bytes;
    };

    // After an exception in one thread, the sink gets no more records, so further blocks would only fill the memory.
    struct StopAll {
        Building& building;
        ~StopAll() { building.next_ = building.built_.size(); }
    };

    void build_until_none_is_left() {
        const StopAll at_the_end{*this};
        BlockBuilder builder(source_);
        for (std::size_t b = next_++; b < built_.size(); b = next_++) {
            auto built = std::make_unique<BuiltBlock>(builder.build(cell_begin_[b], cell_begin_[b + 1]));
            for (const Linked& linked : link(b, std::move(built)))
                put(linked.place, {linked.record.block, linked.record.kind, linked.record.make()});
        }
    }
    [[nodiscard]] std::vector<Linked> link(std::size_t b, std::unique_ptr<BuiltBlock> built) {
        const Locked lock(linking_);
        built_[b] = std::move(built);
        std::vector<Linked> complete;
        for (; linked_ < built_.size() && built_[linked_]; ++linked_)
            for (BlockLinker::CompleteRecord& record : linker_.add(std::move(*std::exchange(built_[linked_], nullptr))))
                complete.push_back({places_++, std::move(record)});
        return complete;
    }
    // After the sink has thrown, it is not called again, because put_ stays at the place of the removed record.
    void put(std::size_t place, Made made) {
        const Locked lock(putting_);
        made_.emplace(place, std::move(made));
        while (!made_.empty() && made_.begin()->first == put_) {
            Made next = std::move(made_.extract(made_.begin()).mapped());
            sink_.put(next.block, next.kind, std::move(next.bytes));
            ++put_;
        }
    }

    const FaceSource& source_;
    std::span<const Index> cell_begin_; // first cell of each block, then the number of cells
    BlockLinker& linker_;
    RecordSink& sink_;
    std::atomic<std::size_t> next_{0}; // the next block to build
    Mutex linking_;
    std::vector<std::unique_ptr<BuiltBlock>> built_; // blocks that are not linked
    std::size_t linked_ = 0, places_ = 0;
    Mutex putting_;
    std::map<std::size_t, Made> made_; // by place: records that wait for an earlier one
    std::size_t put_ = 0;
};

template <class Source>
BuiltBlocks build_from(const Source& source, Topology::Options options, RecordSink& sink) {
    const std::vector<Index> begin = divide(source, std::max<Index>(1, options.cells_per_block));
    const Survey found = survey(source);
    BlockLinker linker(found.last_cell);
    Building(source, begin, linker, sink).run();
    linker.finish();
    return {std::move(linker.numbers()),
            {source.vertex_count(), linker.edge_count(), source.face_count(), linker.half_edge_count(),
             found.boundary_faces, source.cell_count(), found.components}};
}

} // namespace

BuiltBlocks build_blocks(const FaceMeshView& mesh, Topology::Options options, RecordSink& sink) {
    return build_from(FaceMeshSource(mesh), options, sink);
}

} // namespace detail

BuiltRecords build_records(const FaceMeshView& mesh, RecordSink& sink, Topology::Options options) {
    const detail::BuiltBlocks built = detail::build_blocks(mesh, options, sink);
    return {detail::tables_of(built.numbers, built.counts), built.counts};
}

BuiltRecords build_records(const MatchedCells& cells, RecordSink& sink, Topology::Options options) {
    const detail::BuiltBlocks built = detail::build_from(detail::MatchedCellsSource(cells.data()), options, sink);
    return {detail::tables_of(built.numbers, built.counts), built.counts};
}

} // namespace ciel
