// PLOT3D files do not say how they are laid out. What fits is found by arithmetic: the header read under every layout
// and the size such a file must have.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ciel::importer {

enum class Plot3dKind { grid, solution }; // xyz, q

struct Plot3dLayout {
    bool text = false;
    bool big_endian = false;
    bool multi_grid = false;
    bool byte_counts = false; // Fortran records: a 4-byte length before and after each
    bool double_precision = false;
    bool iblank = false;                            // grids only
    std::vector<std::array<std::uint32_t, 3>> dims; // of each grid

    [[nodiscard]] std::uint64_t points(std::size_t grid) const {
        return std::uint64_t{dims[grid][0]} * dims[grid][1] * dims[grid][2];
    }
};

// Binary: every layout under which `head` (the file's first bytes: as many as there are, up to plot3d_head_bytes) is
// the head of a file of exactly `file_size` bytes, or padded with less than 512 to a multiple of 512. Simplest first;
// empty when there is none.
inline constexpr std::size_t plot3d_head_bytes = 256 * 1024;
[[nodiscard]] std::vector<Plot3dLayout> plot3d_binary_layouts(std::span<const std::byte> head, std::uint64_t file_size,
                                                              Plot3dKind kind);

// Text: the same from the first numbers and the count of all numbers in the file.
[[nodiscard]] std::vector<Plot3dLayout> plot3d_text_layouts(std::string_view head, std::uint64_t number_count,
                                                            Plot3dKind kind);

// "big", "little", "multi", "single", "records", "stream", "iblank", "no-iblank", "float32", "float64", "text",
// separated by commas: keeps the layouts that agree. Throws Error for an unknown word.
[[nodiscard]] std::vector<Plot3dLayout> plot3d_restrict(std::vector<Plot3dLayout> layouts, const std::string& words);

// Whether a grid and a solution can belong together: same dimensions and same way of writing.
[[nodiscard]] bool plot3d_match(const Plot3dLayout& grid, const Plot3dLayout& solution);

} // namespace ciel::importer
