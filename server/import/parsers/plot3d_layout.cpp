#include "import/parsers/plot3d_layout.hpp"

#include "ciel/types.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

namespace server::importer {

namespace {

constexpr std::uint32_t max_grids = 10'000;
constexpr std::uint32_t max_dimension = 1U << 20;
constexpr std::uint64_t padding_block = 512; // bytes; tapes and some file systems pad files to a multiple of this size

bool fits(std::uint64_t needed, std::uint64_t size) {
    return needed == size || (size % padding_block == 0 && needed < size && size - needed < padding_block);
}

class HeaderBytes {
public:
    HeaderBytes(std::span<const std::byte> bytes, bool big_endian) : bytes_(bytes), big_endian_(big_endian) {}

    std::optional<std::uint32_t> next() {
        if (position_ + 4 > bytes_.size()) return std::nullopt;
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            const auto byte = std::to_integer<std::uint32_t>(bytes_[position_ + i]);
            value |= byte << (8 * (big_endian_ ? 3 - i : i));
        }
        position_ += 4;
        return value;
    }
    [[nodiscard]] std::uint64_t position() const { return position_; }

private:
    std::span<const std::byte> bytes_;
    bool big_endian_;
    std::size_t position_ = 0;
};

bool plausible(const Plot3dLayout& layout, std::uint64_t most_points) {
    return std::all_of(layout.dims.begin(), layout.dims.end(), [&](const auto& dims) {
        const bool sane = std::all_of(dims.begin(), dims.end(), [](auto n) { return n >= 1 && n <= max_dimension; });
        return sane && std::uint64_t{dims[0]} * dims[1] * dims[2] <= most_points;
    });
}

// In bytes for a binary file, in values for a text file, without the header. `real`, `integer`: size of one value.
std::uint64_t body_size(const Plot3dLayout& layout, Plot3dKind kind, std::uint64_t real, std::uint64_t integer) {
    const std::uint64_t marks = layout.byte_counts ? 8 : 0;
    std::uint64_t size = 0;
    for (std::size_t grid = 0; grid < layout.dims.size(); ++grid) {
        const std::uint64_t points = layout.points(grid);
        if (kind == Plot3dKind::grid)
            size += points * (3 * real + (layout.iblank ? integer : 0)) + marks;
        else
            size += 4 * real + marks + points * 5 * real + marks;
    }
    return size;
}

bool read_binary_header(std::span<const std::byte> head, Plot3dLayout& layout, std::uint64_t& header_size) {
    HeaderBytes bytes(head, layout.big_endian);
    const auto expect = [&](std::uint32_t value) { return bytes.next() == value; };
    std::uint32_t grids = 1;
    if (layout.multi_grid) {
        if (layout.byte_counts && !expect(4)) return false;
        const auto count = bytes.next();
        if (!count || *count < 1 || *count > max_grids) return false;
        grids = *count;
        if (layout.byte_counts && !expect(4)) return false;
    }
    if (layout.byte_counts && !expect(12 * grids)) return false;
    for (std::uint32_t grid = 0; grid < grids; ++grid) {
        const auto i = bytes.next();
        const auto j = bytes.next();
        const auto k = bytes.next();
        if (!k) return false;
        layout.dims.push_back({*i, *j, *k});
    }
    if (layout.byte_counts && !expect(12 * grids)) return false;
    header_size = bytes.position();
    return true;
}

bool next_integer(std::string_view& text, std::uint32_t& value) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n,");
    if (begin == std::string_view::npos) return false;
    text.remove_prefix(begin);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{}) return false;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return true;
}

bool read_text_header(std::string_view head, Plot3dLayout& layout) {
    std::uint32_t grids = 1;
    if (layout.multi_grid && (!next_integer(head, grids) || grids < 1 || grids > max_grids)) return false;
    for (std::uint32_t grid = 0; grid < grids; ++grid) {
        std::array<std::uint32_t, 3> dims{};
        for (std::uint32_t& n : dims)
            if (!next_integer(head, n)) return false;
        layout.dims.push_back(dims);
    }
    return true;
}

} // namespace

std::vector<Plot3dLayout> plot3d_binary_layouts(std::span<const std::byte> head, std::uint64_t file_size,
                                                Plot3dKind kind) {
    std::vector<Plot3dLayout> found;
    for (unsigned bits = 0; bits < 32; ++bits) {
        Plot3dLayout layout;
        layout.big_endian = bits & 1;
        layout.multi_grid = bits & 2;
        layout.byte_counts = bits & 4;
        layout.iblank = bits & 8;
        layout.double_precision = bits & 16;
        if (layout.iblank && kind == Plot3dKind::solution) continue;
        std::uint64_t header_size = 0;
        if (!read_binary_header(head, layout, header_size)) continue;
        const std::uint64_t real = layout.double_precision ? 8 : 4;
        if (!plausible(layout, file_size / (3 * real))) continue;
        if (fits(header_size + body_size(layout, kind, real, 4), file_size)) found.push_back(std::move(layout));
    }
    return found;
}

std::vector<Plot3dLayout> plot3d_text_layouts(std::string_view head, std::uint64_t number_count, Plot3dKind kind) {
    std::vector<Plot3dLayout> found;
    for (const bool multi_grid : {false, true})
        for (const bool iblank : {false, true}) {
            Plot3dLayout layout;
            layout.text = true;
            layout.multi_grid = multi_grid;
            layout.iblank = iblank;
            if (iblank && kind == Plot3dKind::solution) continue;
            if (!read_text_header(head, layout) || !plausible(layout, number_count / 3)) continue;
            const std::uint64_t header = (multi_grid ? 1 : 0) + 3 * layout.dims.size();
            if (header + body_size(layout, kind, 1, 1) == number_count) found.push_back(std::move(layout));
        }
    return found;
}

std::vector<Plot3dLayout> plot3d_restrict(std::vector<Plot3dLayout> layouts, const std::string& words) {
    struct Word {
        std::string_view name;
        bool Plot3dLayout::*member;
        bool value;
    };
    static constexpr Word known[] = {
        {"big", &Plot3dLayout::big_endian, true},
        {"little", &Plot3dLayout::big_endian, false},
        {"multi", &Plot3dLayout::multi_grid, true},
        {"single", &Plot3dLayout::multi_grid, false},
        {"records", &Plot3dLayout::byte_counts, true},
        {"stream", &Plot3dLayout::byte_counts, false},
        {"iblank", &Plot3dLayout::iblank, true},
        {"no-iblank", &Plot3dLayout::iblank, false},
        {"float64", &Plot3dLayout::double_precision, true},
        {"float32", &Plot3dLayout::double_precision, false},
        {"text", &Plot3dLayout::text, true},
    };
    for (std::size_t begin = 0; begin < words.size();) {
        const std::size_t end = std::min(words.find(',', begin), words.size());
        const std::string_view name = std::string_view(words).substr(begin, end - begin);
        const auto* word =
            std::find_if(std::begin(known), std::end(known), [&](const Word& w) { return w.name == name; });
        if (word == std::end(known))
            throw ciel::Error(
                "--plot3d has no word \"" + std::string(name) +
                "\"; use big, little, multi, single, records, stream, iblank, no-iblank, float32, float64, text");
        std::erase_if(layouts, [&](const Plot3dLayout& layout) { return layout.*(word->member) != word->value; });
        begin = end + 1;
    }
    return layouts;
}

bool plot3d_match(const Plot3dLayout& grid, const Plot3dLayout& solution) {
    return grid.dims == solution.dims && grid.text == solution.text && grid.big_endian == solution.big_endian &&
           grid.multi_grid == solution.multi_grid && grid.byte_counts == solution.byte_counts &&
           grid.double_precision == solution.double_precision;
}

} // namespace server::importer
