#include "wire/pictures/picture_stream.hpp"

#include "ciel/types.hpp"
#include "wire/pictures/jpeg_stream.hpp"
#include "wire/pictures/png_stream.hpp"

#include <algorithm>
#include <string>

namespace server::wire {

std::unique_ptr<PictureStream> make_picture_stream(MovingCodec codec, int jpeg_quality) {
    if (codec == MovingCodec::jpeg) return std::make_unique<JpegStream>(jpeg_quality);
    return std::make_unique<PngStream>();
}

void check_picture(const char* format, int longest_side, int width, int height, std::span<const std::uint8_t> rgb) {
    const auto size = std::to_string(width) + " x " + std::to_string(height);
    if (width <= 0 || height <= 0 || std::max(width, height) > longest_side)
        throw ciel::Error("a picture of " + size + " pixels cannot be written as " + format);
    if (rgb.size() != 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
        throw ciel::Error("a picture of " + size + " pixels has " + std::to_string(rgb.size()) +
                          " bytes; it must have 3 bytes for each pixel");
}

} // namespace server::wire
