// How fine interactive pictures are where the line, not the drawing, is what is slow: first of less JPEG quality, then
// smaller, so that as many come as the server makes. The still that follows has all the detail.
#pragma once

#include "wire/pictures/picture_stream.hpp"

#include <cstddef>

namespace ciel::frames {

// A function of what it is told. Not thread-safe.
class PictureDetail {
public:
    struct Detail {
        int quality;  // of a JPEG
        double scale; // of each side
        bool operator==(const Detail&) const = default;
    };

    [[nodiscard]] Detail of(wire::MovingCodec codec) const;
    // A picture of that detail had so many bytes. `making`: seconds of the server for it; `rate`: bytes a second of the
    // line, 0 where nothing says that it is slow.
    void sent(wire::MovingCodec codec, std::size_t bytes, double making, double rate);

private:
    std::size_t level_ = 0;               // 0: the finest
    unsigned too_long_ = 0, fitting_ = 0; // pictures in a row
};

} // namespace ciel::frames
