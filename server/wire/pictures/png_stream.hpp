// Encodes pictures as PNG (ISO/IEC 15948) with zlib and libpng, optimized for speed.
#pragma once

#include "wire/pictures/bands.hpp"
#include "wire/pictures/picture_stream.hpp"
#include "wire/pictures/png_band.hpp"

namespace server::wire {

// Bands are encoded in parallel; unchanged bands keep their bytes. Each band is an IDAT chunk, because deflate blocks
// may end at any byte (RFC 1951, 3.2.4), and Adler-32 sums can be combined (RFC 1950, 8.2).
class PngStream final : public PictureStream {
public:
    void encode(int width, int height, std::span<const std::uint8_t> rgb, std::vector<std::uint8_t>& out) override;

private:
    Bands<PngBand> bands_;
};

} // namespace server::wire
