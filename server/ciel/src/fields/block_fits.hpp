// BlockFits: the least-squares fits of the polyhedra of one block, each made when first needed. Not in the paper.
#pragma once

#include "fields/polyhedron_gradient.hpp"

#include <cstdint>
#include <vector>

namespace ciel::detail {

template <class Local>
class BlockFits {
public:
    // Removes all fits. Call it before the first `of`. `cells`: number of cells of the PolyhedralSection.
    void begin(Index cells) {
        number_.assign(cells, none);
        first_vertex_.assign(1, 0);
        fit_.clear();
        vertex_.clear();
    }
    // Returns the fit of a cell, which is valid until the next call. The first call for a cell keeps the result of
    // make(), which must be a FittedPolyhedron<Index>.
    template <class Make>
    [[nodiscard]] FittedPolyhedron<Local> of(Index cell, Make&& make) {
        if (number_[cell] == none) add(cell, make());
        const Index number = number_[cell], begin = first_vertex_[number];
        return {fit_[number], std::span<const Local>(vertex_).subspan(begin, first_vertex_[number + 1] - begin)};
    }
    [[nodiscard]] std::size_t memory_bytes() const {
        return number_.capacity() * sizeof(Index) + first_vertex_.capacity() * sizeof(Index) +
               fit_.capacity() * sizeof(PolyhedronFit) + vertex_.capacity() * sizeof(Local);
    }

private:
    void add(Index cell, const FittedPolyhedron<Index>& made) {
        vertex_.resize(first_vertex_.back()); // an earlier call may have left entries when it threw std::bad_alloc
        fit_.resize(first_vertex_.size() - 1);
        for (const Index v : made.vertices) vertex_.push_back(static_cast<Local>(v));
        fit_.push_back(made.fit);
        first_vertex_.push_back(static_cast<Index>(vertex_.size()));
        number_[cell] = static_cast<Index>(fit_.size() - 1);
    }

    std::vector<Index> number_;       // by cell of the section: index in fit_, or none
    std::vector<PolyhedronFit> fit_;  // in the order in which the fits were made
    std::vector<Index> first_vertex_; // index in vertex_ of each fit's first vertex, then the size of vertex_
    std::vector<Local> vertex_;
};

} // namespace ciel::detail
