#include "wire/pictures/jpeg_stream.hpp"

namespace server::wire {
namespace {
constexpr int longest_side = 65500; // pixels; JPEG_MAX_DIMENSION of libjpeg
constexpr std::uint8_t end_of_image = 0xD9;
} // namespace

void JpegStream::encode(int width, int height, std::span<const std::uint8_t> rgb, std::vector<std::uint8_t>& out) {
    check_picture("JPEG", longest_side, width, height, rgb);
    const std::vector<JpegBand>& bands = bands_.encode(width, height, rgb, quality_);
    const auto header = bands.front().header();
    out.insert(out.end(), header.begin(), header.end());
    std::size_t piece = 0;
    for (const JpegBand& band : bands) piece = band.append(piece, out);
    out.back() = end_of_image; // replaces the restart marker of the last piece
}

} // namespace server::wire
