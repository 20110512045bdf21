#include "import/mesh/degenerate_cells.hpp"

#include <algorithm>

namespace server::importer {

namespace {

constexpr std::size_t least_corners = 4; // a cell with fewer distinct corners has no volume

class Found {
public:
    void add(ciel::Index cell) {
        constexpr std::size_t shown = 10;
        if (count_++ < shown) first_ += (first_.empty() ? "" : ", ") + std::to_string(cell);
    }
    [[nodiscard]] bool any() const { return count_ > 0; }
    [[nodiscard]] std::string sentence(const std::string& one, const std::string& many) const {
        return std::to_string(count_) + (count_ == 1 ? " cell has " + one : " cells have " + many) +
               " (first ids: " + first_ + ").";
    }

private:
    std::uint64_t count_ = 0;
    std::string first_;
};

bool has_repeated(std::vector<ciel::Index>& corners) {
    std::sort(corners.begin(), corners.end());
    const auto end = std::unique(corners.begin(), corners.end());
    const bool repeated = end != corners.end();
    corners.erase(end, corners.end());
    return repeated;
}

} // namespace

std::vector<std::string> degenerate_cells(const JoinedMesh& joined) {
    Found collapsed, flat;
    std::vector<ciel::Index> loop, corners;
    for (std::size_t cell = 0; cell < joined.cell_types.size(); ++cell) {
        bool repeated = false;
        corners.clear();
        joined.for_loops(cell, [&](std::span<const ciel::Index> of_face) {
            loop.assign(of_face.begin(), of_face.end());
            repeated = has_repeated(loop) || repeated;
            corners.insert(corners.end(), loop.begin(), loop.end());
        });
        if (!repeated) continue;
        (void)has_repeated(corners);
        (corners.size() < least_corners ? flat : collapsed).add(joined.source_cell[cell]);
    }
    std::vector<std::string> sentences;
    if (collapsed.any())
        sentences.push_back(collapsed.sentence("coincident corners and was kept", "coincident corners and were kept"));
    if (flat.any())
        sentences.push_back(flat.sentence("fewer than four different corners and no volume, and was kept",
                                          "fewer than four different corners and no volume, and were kept"));
    return sentences;
}

} // namespace server::importer
