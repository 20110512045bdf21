// cut_one_block PARCEL SURFACE: cuts a block of a mesh of which this process has nothing else (block_parcel.hpp). It
// uses the kernel's public headers only.
#include "oracle/block_parcel.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <limits>
#include <memory>
#include <span>
#include <utility>

namespace ciel::test {
namespace {

constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

class OneRecord final : public RecordSource {
public:
    OneRecord(Index block, std::vector<std::uint64_t> record) : block_(block), record_(std::move(record)) {}

    std::span<const std::byte> record(Index block, RecordKind kind) override {
        if (block != block_ || kind != RecordKind::cells) throw Error("another record was read");
        return std::as_bytes(std::span(record_));
    }
    [[nodiscard]] std::size_t memory_bytes() const override { return 0; }

private:
    Index block_;
    std::vector<std::uint64_t> record_;
};

// Returns the positions of all vertices of the mesh: numbers that no result must have, except at those of the block.
FaceMesh points_of(const BlockParcel& parcel, const TopologyCounts& counts) {
    FaceMesh mesh;
    mesh.origin = parcel.origin;
    mesh.cell_types.resize(counts.cells);
    mesh.positions.resize(3 * counts.vertices, unknown);
    for (std::size_t i = 0; i < parcel.positions.size(); ++i)
        mesh.positions[std::size_t{3} * parcel.vertices[i / 3] + i % 3] = parcel.positions[i];
    return mesh;
}

Field field_of(const BlockParcel& parcel, const Topology& topology) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    BlockRanges ranges{std::vector<double>(topology.block_count(), infinity),
                       std::vector<double>(topology.block_count(), -infinity),
                       std::vector<std::uint32_t>(topology.block_count(), 0)};
    const auto [low, high] = std::ranges::minmax(parcel.values);
    ranges.low[parcel.block[0]] = low;
    ranges.high[parcel.block[0]] = high;
    const auto values = std::make_shared<std::vector<float>>(topology.counts().vertices, unknown);
    for (std::size_t i = 0; i < parcel.vertices.size(); ++i) (*values)[parcel.vertices[i]] = parcel.values[i];
    return {topology, ValuesView(*values), ranges, values};
}

Surface surface_of(const BlockParcel& parcel) {
    const Topology topology(std::as_bytes(std::span(parcel.tables)),
                            std::make_unique<OneRecord>(parcel.block[0], parcel.record));
    Query query(topology, shared_view(points_of(parcel, topology.counts())));
    query.set_field(field_of(parcel, topology));
    query.set_blocks(parcel.block);
    Surface surface;
    (void)query.extract(parcel.nu[0], false, surface);
    return surface;
}

} // namespace
} // namespace ciel::test

int main(int count, char** arguments) {
    if (count != 3) return 2;
    try {
        ciel::test::write(arguments[2],
                          ciel::test::surface_of(ciel::test::read<ciel::test::BlockParcel>(arguments[1])));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
