// Pictures that follow each other quickly, each coded as a file of its own.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace ciel::wire {

enum class MovingCodec { png, jpeg };

// What is as it was in the last picture keeps its bytes. Use one by one; each call has the thread pool's help.
class PictureStream {
public:
    PictureStream() = default;
    virtual ~PictureStream() = default;
    PictureStream(const PictureStream&) = delete;
    PictureStream& operator=(const PictureStream&) = delete;

    // rgb: rows from the top, 3 bytes a pixel. Appends to `out`. Throws Error when sizes do not agree or are more than
    // the codec has; the next call is not affected.
    virtual void encode(int width, int height, std::span<const std::uint8_t> rgb, std::vector<std::uint8_t>& out) = 0;
};

// `jpeg_quality`: 1 to 100; a PNG has all of it.
[[nodiscard]] std::unique_ptr<PictureStream> make_picture_stream(MovingCodec codec, int jpeg_quality = 80);

// Throws Error, in words that name the format, unless `rgb` has 3 bytes for each pixel and no side is longer.
void check_picture(const char* format, int longest_side, int width, int height, std::span<const std::uint8_t> rgb);

} // namespace ciel::wire
