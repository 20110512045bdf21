// Encodes a picture in bands of rows, in parallel. A band keeps its encoded bytes for the next picture.
#pragma once

#include "ciel/parallel.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace server::wire {

// A Band needs a constructor (width, height, first row, more...), the constant most_rows, and encode(rgb), which takes
// the pixels of the whole picture.
template <class Band>
class Bands {
public:
    // Returns the bands from the top, valid until the next call. `more` must be the same in all calls. Rethrows
    // exceptions of bands; the next call then encodes all bands again.
    template <class... More>
    const std::vector<Band>& encode(int width, int height, std::span<const std::uint8_t> rgb, More... more) {
        if (width != width_ || height != height_) bands_.clear();
        width_ = width;
        height_ = height;
        if (bands_.empty())
            for (int top = 0; top < height; top += Band::most_rows) bands_.emplace_back(width, height, top, more...);
        try {
            ciel::parallel_for(bands_.size(), 1, [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i) bands_[i].encode(rgb);
            });
        } catch (...) {
            bands_.clear(); // some bands already hold rows of the failed picture
            throw;
        }
        return bands_;
    }

private:
    int width_ = 0, height_ = 0;
    std::vector<Band> bands_;
};

} // namespace server::wire
