// A block is cut in a process that has nothing else of the mesh: its record, its entry in the index and those of the
// owners of its ghosts, and the values and positions of its vertices. A browser or another machine can do the same.
#include "blocks/block_tables.hpp"
#include "blocks/blocks.hpp"
#include "oracle/block_parcel.hpp"
#include "oracle/kernel_mesh.hpp"
#include "support/fields.hpp"
#include "support/folder.hpp"
#include "support/meshes.hpp"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <set>
#include <span>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ciel::test {

using namespace ciel::detail;

namespace {

// Returns the block and the owners of its ghosts.
std::set<Index> entries_of(Index block, const Block& of, const BlockNumbers& numbers) {
    std::set<Index> entries{block};
    const auto add_owners = [&entries](const Ghosts& ghosts, const std::vector<Index>& begin) {
        ghosts.for_each([&](Index id) {
            entries.insert(static_cast<Index>(std::ranges::upper_bound(begin, id) - begin.begin() - 1));
        });
    };
    add_owners(of.ghost_vertex, numbers.vertex);
    add_owners(of.ghost_edge, numbers.edge);
    return entries;
}

// Returns tables in which only the numbers of the blocks in `entries` are those of the mesh. The others are made up.
RecordBytes tables_with(const std::set<Index>& entries, Index block, const BlockNumbers& all) {
    const auto kept = [&](const std::vector<Index>& begin) {
        std::vector<Index> made{0};
        for (Index b = 0; b < all.block_count(); ++b) {
            if (entries.contains(b)) made.back() = begin[b];
            made.push_back(entries.contains(b) ? begin[b + 1] : made.back());
        }
        return made;
    };
    BlockNumbers numbers{kept(all.cell), kept(all.vertex), kept(all.edge), {0}, {}, {}};
    for (Index b = 0; b < all.block_count(); ++b) {
        const Index vertices = b == block ? all.slot[b + 1] - all.slot[b] : numbers.vertex[b + 1] - numbers.vertex[b];
        numbers.slot.push_back(numbers.slot.back() + vertices);
        numbers.half_edges.push_back(b == block ? all.half_edges[b] : 0);
        numbers.border_vertices.push_back(0);
    }
    TopologyCounts counts;
    counts.cells = numbers.cell.back();
    counts.vertices = numbers.vertex.back();
    counts.edges = numbers.edge.back();
    counts.half_edges = numbers.half_edges[block];
    return tables_of(numbers, counts);
}

BlockParcel parcel_of(const KernelMesh& mesh, std::span<const float> stored, Index block, double nu) {
    const Topology::Blocks& blocks = mesh.topology.blocks();
    const Block& of = blocks.cells(block);
    BlockParcel parcel;
    parcel.block = {block};
    parcel.nu = {nu};
    parcel.origin = mesh.mesh().origin;
    parcel.tables = tables_with(entries_of(block, of, blocks.numbers), block, blocks.numbers);
    const std::span<const std::byte> record = mesh.topology.record(block, RecordKind::cells);
    parcel.record.resize(record.size() / sizeof parcel.record[0]);
    std::ranges::copy(record, std::as_writable_bytes(std::span(parcel.record)).begin());
    for (Index local = 0; local < of.vertex_count; ++local) {
        const Index vertex = of.vertex(local);
        parcel.vertices.push_back(vertex);
        parcel.values.push_back(stored[vertex]);
        for (const float at : mesh.mesh().positions.floats().subspan(std::size_t{3} * vertex, 3))
            parcel.positions.push_back(at);
    }
    return parcel;
}

// Returns the exit status of the program `cut_one_block`.
int cut(std::string parcel, std::string surface) {
    std::string program = CIEL_BINARY_DIR "/cut_one_block";
    const std::array<char*, 4> arguments{program.data(), parcel.data(), surface.data(), nullptr};
    pid_t child = 0;
    if (::posix_spawn(&child, program.c_str(), nullptr, nullptr, arguments.data(), environ) != 0) return -1;
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(OneBlock, IsCutByAProcessThatHasNoOther) {
    const Folder folder;
    const Polyhedra input = zoo({{6, 6, 6}, 0.1, 407});
    const KernelMesh mesh(input, {64});
    const std::vector<float> stored = mesh.stored(bumps_field(input, 408));
    const Field field = make_field(mesh.topology, stored);
    Query query = mesh.query();
    query.set_field(field);
    Surface all;
    ASSERT_TRUE(query.extract(0.5, false, all));
    ASSERT_GT(all.chunks.size(), 10U);
    for (const Surface::Chunk& chunk : all.chunks) {
        const std::string parcel = (folder / "parcel").string(), surface = (folder / "surface").string();
        write(parcel, parcel_of(mesh, stored, chunk.block, 0.5));
        ASSERT_EQ(cut(parcel, surface), 0);
        ASSERT_EQ(bit_difference(only(all, {chunk.block}), read<Surface>(surface)), "") << chunk.block;
    }
}

} // namespace
} // namespace ciel::test
