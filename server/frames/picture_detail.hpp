// Reduces the detail of interactive pictures if the line is slower than the drawing: first the JPEG quality, then the
// size. The line then carries as many pictures as the server makes. The still picture that follows has full detail.
#pragma once

#include "wire/pictures/picture_stream.hpp"

#include <cstddef>

namespace server::frames {

// PictureDetail is deterministic. It is not thread-safe.
class PictureDetail {
public:
    struct Detail {
        int quality;  // JPEG quality
        double scale; // factor on width and height
        bool operator==(const Detail&) const = default;
    };

    [[nodiscard]] Detail of(wire::MovingCodec codec) const;
    // `making`: seconds that making the picture took. `rate`: bytes per second; 0: the line is not known to be slow.
    void sent(wire::MovingCodec codec, std::size_t bytes, double making, double rate);

private:
    std::size_t level_ = 0; // 0: the finest
    // Numbers of pictures in a row that were too large for the line, and that would also fit at the next finer level.
    unsigned too_long_ = 0, fitting_ = 0;
};

} // namespace server::frames
