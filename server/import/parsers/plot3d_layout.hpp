// Finds the layout of a PLOT3D file, which the file does not declare: reads the header under every possible layout and
// keeps those whose computed size equals the size of the file.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ciel::importer {

enum class Plot3dKind { grid, solution }; // files that PLOT3D calls xyz and q

struct Plot3dLayout {
    bool text = false;
    bool big_endian = false;
    bool multi_grid = false;
    bool byte_counts = false; // Fortran records: a 4-byte length before and after each
    bool double_precision = false;
    bool iblank = false;                            // grids only
    std::vector<std::array<std::uint32_t, 3>> dims; // number of points along i, j, k of each grid

    [[nodiscard]] std::uint64_t points(std::size_t grid) const {
        return std::uint64_t{dims[grid][0]} * dims[grid][1] * dims[grid][2];
    }
};

// Returns every layout under which a binary file that starts with `head` has `file_size` bytes, or fewer and is padded
// to the next multiple of 512. Simplest first. `head`: the first plot3d_head_bytes of the file, or all of it.
inline constexpr std::size_t plot3d_head_bytes = 256 * 1024;
[[nodiscard]] std::vector<Plot3dLayout> plot3d_binary_layouts(std::span<const std::byte> head, std::uint64_t file_size,
                                                              Plot3dKind kind);

// Returns every layout under which a text file that starts with `head` has `number_count` numbers.
[[nodiscard]] std::vector<Plot3dLayout> plot3d_text_layouts(std::string_view head, std::uint64_t number_count,
                                                            Plot3dKind kind);

// Keeps the layouts that agree with all `words`: "big", "little", "multi", "single", "records", "stream", "iblank",
// "no-iblank", "float32", "float64", "text", separated by commas. Throws Error for an unknown word.
[[nodiscard]] std::vector<Plot3dLayout> plot3d_restrict(std::vector<Plot3dLayout> layouts, const std::string& words);

// Whether a grid and a solution can belong together: they have the same dimensions and encoding.
[[nodiscard]] bool plot3d_match(const Plot3dLayout& grid, const Plot3dLayout& solution);

} // namespace ciel::importer
