// Finds the layout of a PLOT3D file. The file does not declare its layout. Therefore these functions read the header
// under every possible layout. They keep each layout for which the computed size equals the size of the file.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace server::importer {

enum class Plot3dKind { grid, solution }; // PLOT3D calls a grid file xyz and a solution file q

struct Plot3dLayout {
    bool text = false;
    bool big_endian = false;
    bool multi_grid = false;
    bool byte_counts = false; // Fortran records: a 4-byte length before and after each record
    bool double_precision = false;
    bool iblank = false;                            // only in grid files
    std::vector<std::array<std::uint32_t, 3>> dims; // number of points along i, j, k of each grid

    [[nodiscard]] std::uint64_t points(std::size_t grid) const {
        return std::uint64_t{dims[grid][0]} * dims[grid][1] * dims[grid][2];
    }
};

// Returns the layouts that fit the file. Single precision comes before double precision, and layouts without iblank
// come before layouts with iblank. `head`: the first plot3d_head_bytes of the file, or the whole file if it is shorter.
inline constexpr std::size_t plot3d_head_bytes = 256 * 1024;
[[nodiscard]] std::vector<Plot3dLayout> plot3d_binary_layouts(std::span<const std::byte> head, std::uint64_t file_size,
                                                              Plot3dKind kind);

[[nodiscard]] std::vector<Plot3dLayout> plot3d_text_layouts(std::string_view head, std::uint64_t number_count,
                                                            Plot3dKind kind);

// Returns the layouts that agree with all `words`. `words` is a list separated by commas of: big, little, multi,
// single, records, stream, iblank, no-iblank, float32, float64, text. Throws Error for an unknown word.
[[nodiscard]] std::vector<Plot3dLayout> plot3d_restrict(std::vector<Plot3dLayout> layouts, const std::string& words);

// Returns whether both files have the same dimensions and encoding.
[[nodiscard]] bool plot3d_match(const Plot3dLayout& grid, const Plot3dLayout& solution);

} // namespace server::importer
