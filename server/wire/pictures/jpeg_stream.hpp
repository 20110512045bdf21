// Encodes pictures as JPEG (ITU-T T.81) with libjpeg.
#pragma once

#include "wire/pictures/bands.hpp"
#include "wire/pictures/jpeg_band.hpp"
#include "wire/pictures/picture_stream.hpp"

namespace server::wire {

// Pieces of about 64 x 16 pixels end at restart markers (T.81, B.2.4.4), and are encoded in parallel. Unchanged pieces
// keep their bytes. The decoded pixels equal the pixels of a single libjpeg call.
class JpegStream final : public PictureStream {
public:
    explicit JpegStream(int quality = 80) : quality_(quality) {}
    void encode(int width, int height, std::span<const std::uint8_t> rgb, std::vector<std::uint8_t>& out) override;

private:
    int quality_;
    Bands<JpegBand> bands_;
};

} // namespace server::wire
