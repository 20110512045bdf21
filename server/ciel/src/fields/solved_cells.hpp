// The gradients of some cells of a block. Not in the paper.
#pragma once

#include "fields/cell_gradient.hpp"

#include <cstdint>
#include <vector>

namespace ciel::detail {

// `place`: the index of a cell in the concatenated sections of the block.
class SolvedCells {
public:
    void begin(std::size_t cells) {
        number_.assign(cells, none);
        gradient_.clear();
    }
    void add(std::size_t place, const CellGradient& gradient) {
        number_[place] = static_cast<Index>(gradient_.size());
        gradient_.push_back(gradient);
    }
    // Returns the gradient of the cell, or null if the cell was not added.
    [[nodiscard]] const CellGradient* of(std::size_t place) const {
        if (place >= number_.size() || number_[place] == none) return nullptr;
        return &gradient_[number_[place]];
    }

private:
    std::vector<Index> number_; // by place: index in gradient_, or none
    std::vector<CellGradient> gradient_;
};

} // namespace ciel::detail
