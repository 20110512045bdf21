// A picture in bands of rows, which are coded side by side and keep what they have coded for the next picture.
#pragma once

#include "ciel/parallel.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace ciel::wire {

// Band: made of (width, height, first row, what else is given), at most Band::most_rows of them, and encode(rgb) of the
// whole picture.
template <class Band>
class Bands {
public:
    // From the top, good until the next call. `more`: always the same. Throws what a band throws; the next picture is
    // coded from nothing then.
    template <class... More>
    const std::vector<Band>& encode(int width, int height, std::span<const std::uint8_t> rgb, More... more) {
        if (width != width_ || height != height_) bands_.clear();
        width_ = width;
        height_ = height;
        if (bands_.empty())
            for (int top = 0; top < height; top += Band::most_rows) bands_.emplace_back(width, height, top, more...);
        try {
            parallel_for(bands_.size(), 1, [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i) bands_[i].encode(rgb);
            });
        } catch (...) {
            bands_.clear(); // else half of this picture would be taken for the last one's
            throw;
        }
        return bands_;
    }

private:
    int width_ = 0, height_ = 0;
    std::vector<Band> bands_;
};

} // namespace ciel::wire
