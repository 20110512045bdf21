// An array of values or positions on the disk. It has one chunk file for each step or coordinate set. The ranges of a
// chunk and the checksums of its stretches are in another file beside the chunk file.
#pragma once

#include "ciel/value_source.hpp"
#include "store/cache/checked_file.hpp"
#include "store/format/layout.hpp"
#include "store/format/value_ranges.hpp"
#include "store/format/values.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace server::store {

struct ArrayLayout {
    std::filesystem::path directory;
    std::uint64_t chunks = 0;
    std::size_t rank = 0, chunk_bytes = 0;
    bool doubles = false;

    [[nodiscard]] std::filesystem::path chunk(std::uint64_t index) const {
        return layout::chunk(directory, index, rank);
    }
};

// Reads the .zarray of an array. Throws Error that names this file unless a chunk has items x components values of type
// float32 or float64.
[[nodiscard]] ArrayLayout read_layout(const std::filesystem::path& directory, std::uint64_t items, int components);

// Returns the ranges of a chunk; nullopt if no ranges are stored, if they were written for another chunk, or if `sum`,
// the checksum of the chunk, is empty. Throws Error when the file is damaged or has other numbers of scalars or blocks.
[[nodiscard]] std::optional<ValueRanges> read_ranges(const ArrayLayout& array, std::uint64_t chunk,
                                                     const std::string& sum, std::size_t scalars, std::size_t blocks,
                                                     const std::string& dataset_id);

// Returns the stretch size and the checksums of a chunk's stretches. If `ranges` has no checksums of stretches, the
// whole chunk is one stretch with the checksum `sum`. If `sum` is empty, there is no checksum.
[[nodiscard]] StretchChecks checks_of_stretches(const ArrayLayout& array, const std::string& sum,
                                                std::optional<ValueRanges> ranges);

// Throws Error that names `file` when a stretch of positions contains a number that is not finite.
void refuse_infinite(std::span<const std::byte> stretch, bool doubles, const std::filesystem::path& file);

// Returns the values of the chunk, none of them loaded.
[[nodiscard]] ValuesToLoad view_of(std::shared_ptr<const CheckedFile> chunk, bool doubles);
[[nodiscard]] Values loaded(ValuesToLoad to_load); // loads all stretches

// Loads the positions of the vertices that the kernel requests. Keeps their file mapped.
class PositionsLoader final : public ciel::VertexLoader {
public:
    PositionsLoader(ValuesToLoad positions, std::size_t blocks)
        : ciel::VertexLoader(blocks), file_(std::move(positions.file)),
          vertex_bytes_(3 * (positions.values.has_doubles() ? sizeof(double) : sizeof(float))) {}

    void load(ciel::Index begin, ciel::Index end) const override {
        file_->load(begin * vertex_bytes_, end * vertex_bytes_);
    }

private:
    std::shared_ptr<const CheckedFile> file_;
    std::size_t vertex_bytes_;
};

} // namespace server::store
