// Encodes pictures in quick succession, each as a complete file.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace server::wire {

enum class MovingCodec { png, jpeg };

// Not thread-safe; each call uses the thread pool. Parts of the picture that have not changed keep their encoded bytes.
class PictureStream {
public:
    PictureStream() = default;
    virtual ~PictureStream() = default;
    PictureStream(const PictureStream&) = delete;
    PictureStream& operator=(const PictureStream&) = delete;

    // `rgb`: rows from the top. Throws Error if sizes do not match or exceed the codec's limit; later calls still work.
    virtual void encode(int width, int height, std::span<const std::uint8_t> rgb, std::vector<std::uint8_t>& out) = 0;
};

// Returns an encoder. `jpeg_quality`: 1 to 100; ignored for PNG, which is lossless.
[[nodiscard]] std::unique_ptr<PictureStream> make_picture_stream(MovingCodec codec, int jpeg_quality = 80);

// Throws Error, which names the format, unless the sizes match and both sides are from 1 to `longest_side`.
void check_picture(const char* format, int longest_side, int width, int height, std::span<const std::uint8_t> rgb);

} // namespace server::wire
