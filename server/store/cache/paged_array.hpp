// An array of values or positions in its files: one chunk a step or coordinate set, each with its pages and ranges.
#pragma once

#include "ciel/value_source.hpp"
#include "store/cache/paged_file.hpp"
#include "store/format/layout.hpp"
#include "store/format/value_ranges.hpp"
#include "store/format/values.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace ciel::store {

// Location and shape of one array on one mesh. Each chunk is one step, or one coordinate set of the positions.
struct ArrayLayout {
    std::filesystem::path directory;
    std::uint64_t chunks = 0;
    std::size_t rank = 0, chunk_bytes = 0;
    bool doubles = false;

    [[nodiscard]] std::filesystem::path chunk(std::uint64_t index) const {
        return layout::chunk(directory, index, rank);
    }
};

// Throws Error that names the .zarray when it does not hold one chunk of float32 or float64 per step, of items x
// components values.
[[nodiscard]] ArrayLayout read_layout(const std::filesystem::path& directory, std::uint64_t items, int components);

// Returns the ranges that are stored beside a chunk; nullopt if there are none, or if they belong to another chunk.
// `sum`: checksum of the chunk; if it is empty, nullopt is returned. `scalars`, `blocks`: how many of these the ranges
// must have. Throws Error when the file is damaged.
[[nodiscard]] std::optional<ValueRanges> read_ranges(const ArrayLayout& array, std::uint64_t chunk,
                                                     const std::string& sum, std::size_t scalars, std::size_t blocks,
                                                     const std::string& dataset_id);

// Returns the checksums with which the pages of a chunk are compared. A chunk whose pages have no checksums is one
// page.
[[nodiscard]] PageChecks page_checks(const ArrayLayout& array, const std::string& sum,
                                     std::optional<ValueRanges> ranges);

// Throws Error that names the file when a page of positions has a number that is not finite.
void refuse_infinite(std::span<const std::byte> page, bool doubles, const std::filesystem::path& file);

[[nodiscard]] PagedValues view_of(std::shared_ptr<const PagedFile> chunk, bool doubles);
[[nodiscard]] Values loaded(PagedValues paged); // loads all pages

// Loads positions by vertex. Keeps their file open.
class PositionsLoader final : public VertexLoader {
public:
    PositionsLoader(PagedValues positions, std::size_t blocks)
        : VertexLoader(blocks), file_(std::move(positions.file)),
          vertex_bytes_(3 * (positions.values.has_doubles() ? sizeof(double) : sizeof(float))) {}

    void load(Index begin, Index end) const override { file_->load(begin * vertex_bytes_, end * vertex_bytes_); }

private:
    std::shared_ptr<const PagedFile> file_;
    std::size_t vertex_bytes_;
};

} // namespace ciel::store
