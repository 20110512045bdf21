// Reduces the detail of interactive pictures if the line is slower than the drawing: first the JPEG quality, then the
// size. The line then carries as many pictures as the server makes. The still that follows has full detail.
#pragma once

#include "wire/pictures/picture_stream.hpp"

#include <cstddef>

namespace ciel::frames {

// PictureDetail is deterministic. It is not thread-safe.
class PictureDetail {
public:
    struct Detail {
        int quality;  // of a JPEG
        double scale; // factor for each side
        bool operator==(const Detail&) const = default;
    };

    [[nodiscard]] Detail of(wire::MovingCodec codec) const;
    // Reports the size of a sent picture. `making`: seconds that the server took for it. `rate`: bytes per second of
    // the line, 0 if it is not known to be slow.
    void sent(wire::MovingCodec codec, std::size_t bytes, double making, double rate);

private:
    std::size_t level_ = 0;               // 0: the finest
    unsigned too_long_ = 0, fitting_ = 0; // pictures in a row that were too long, or for which a finer one would fit
};

} // namespace ciel::frames
