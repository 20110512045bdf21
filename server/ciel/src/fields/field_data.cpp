#include "fields/field_data.hpp"

#include "blocks/blocks.hpp"
#include "blocks/load_vertices.hpp"
#include "ciel/of_this_thread.hpp"
#include "fields/cell_fits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ciel {

using namespace detail;

void Field::Data::begin(const Topology& of, BlockRanges block_ranges) {
    const Topology::Blocks& all = of.blocks();
    if (block_ranges.low.size() != all.count() || block_ranges.high.size() != all.count() ||
        block_ranges.missing.size() != all.count())
        fail("the ranges belong to another mesh; pass one range per block of the topology");
    topology = of;
    // The array is longer than the values by local_ids, because a changed record may have any 16-bit number as a local
    // vertex. Entries that are never used take no memory.
    const std::size_t room = all.slot_count() + local_ids;
    if (has_doubles())
        local_doubles = SparseArray<double>(room);
    else
        local_floats = SparseArray<float>(room);
    taken = std::make_unique<std::atomic<bool>[]>(all.count());
    ranges.resize(all.count());
    of_blocks = std::move(block_ranges);
}

std::array<double, 2> Field::Data::range_of_blocks() const {
    if (of_blocks.low.empty()) return {};
    const double low = *std::ranges::min_element(of_blocks.low), high = *std::ranges::max_element(of_blocks.high);
    return low <= high ? std::array{low, high} : std::array<double, 2>{};
}

double Field::Data::threshold(double nu) const {
    if (std::isnan(nu)) return std::numeric_limits<double>::infinity();
    if (has_doubles()) return nu;
    const auto nearest = static_cast<float>(nu);
    return nearest >= nu ? nearest : std::nextafter(nearest, std::numeric_limits<float>::infinity());
}

namespace {

template <class Value>
class Given {
public:
    explicit Given(std::span<const Value> values) : values_(values) {}
    [[nodiscard]] Value at(std::size_t vertex) const { return values_[vertex]; }

private:
    std::span<const Value> values_;
};

template <class Values, class Value>
void copy_block(const Block& block, const Values& values, Value* to) {
    block.ghost_vertex.for_each([&](Index vertex) { *to++ = values.at(vertex); });
    const std::size_t end = block.own_vertex_begin + (block.vertex_count - block.ghost_vertex.size());
    for (std::size_t v = block.own_vertex_begin; v < end; ++v) *to++ = values.at(v);
}

struct Ghosts {
    std::vector<Index> vertices; // scratch of read_block
};

template <class Value>
void read_block(const Block& block, const ValueSource& source, Value* to) {
    std::vector<Index>& ghosts = of_this_thread<Ghosts>().vertices;
    ghosts.clear();
    block.ghost_vertex.for_each([&](Index vertex) { ghosts.push_back(vertex); });
    source.read(ghosts, std::span(to, ghosts.size()));
    source.read(block.own_vertex_begin, std::span(to + ghosts.size(), block.vertex_count - ghosts.size()));
}

} // namespace

// Writes the values of the block to its entries in `local`. Values that are not finite become NaN.
template <class Value>
void Field::Data::take_in(Index b, Value* local) const {
    const Block& block = topology->blocks().cells(b);
    Value* const begin = local + block.vertex_begin;
    if (source) {
        read_block(block, *source, begin);
    } else if (plane) {
        load_vertices(plane->loader(), b, block);
        copy_block(block, plane->of<Value>(), begin);
    } else {
        copy_block(block, Given(std::span(static_cast<const Value*>(values.data()), values.size())), begin);
    }
    if (!has_gaps(b)) return;
    for (Value* each = begin; each < begin + block.vertex_count; ++each)
        if (!std::isfinite(*each)) *each = std::numeric_limits<Value>::quiet_NaN();
}

void Field::Data::take_in(Index b) const {
    const Locked lock(take_in_mutex[b % take_in_mutex.size()]);
    if (taken[b].load(std::memory_order_relaxed)) return;
    if (has_doubles())
        take_in(b, local_doubles.get());
    else
        take_in(b, local_floats.get());
    taken[b].store(true, std::memory_order_release);
}

double Field::Data::value_alone(Index vertex) const {
    if (plane && plane->loader() != nullptr) plane->loader()->load(vertex, vertex + 1);
    if (!source) return value(vertex);
    const auto read = [&](auto alone) {
        source->read(std::span(&vertex, 1), std::span(&alone, 1));
        return double{alone};
    };
    return has_doubles() ? read(double{}) : read(float{});
}

void Field::Data::read_all() const {
    if (plane && plane->loader() != nullptr) plane->loader()->load(0, static_cast<Index>(plane->vertex_count()));
    if (!source) return;
    const Locked lock(reading_all_);
    if (all_) return;
    const auto read = [this]<class Value>(std::shared_ptr<std::vector<Value>> all) {
        source->read(Index{0}, std::span(*all));
        values = *all;
        all_ = std::move(all);
    };
    if (has_doubles())
        read(std::make_shared<std::vector<double>>(source->size()));
    else
        read(std::make_shared<std::vector<float>>(source->size()));
}

CellFits::Data* Field::Data::shared_fits(const FaceMeshView& cut) const {
    return fits && fits->data().belong_to(cut.positions.data()) ? &fits->data() : nullptr;
}

} // namespace ciel
