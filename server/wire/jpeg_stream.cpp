#include "wire/jpeg_stream.hpp"

#include "ciel/parallel.hpp"

namespace ciel::wire {
namespace {
constexpr int longest_side = 65500; // libjpeg's own limit
constexpr std::uint8_t end_of_image = 0xD9;
} // namespace

void JpegStream::encode(int width, int height, std::span<const std::uint8_t> rgb, std::vector<std::uint8_t>& out) {
    check_picture("JPEG", longest_side, width, height, rgb);
    if (width != width_ || height != height_) bands_.clear();
    width_ = width;
    height_ = height;
    if (bands_.empty())
        for (int top = 0; top < height; top += JpegBand::most_rows) bands_.emplace_back(width, height, top);
    try {
        parallel_for(bands_.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) bands_[i].encode(rgb);
        });
    } catch (...) {
        bands_.clear(); // else the next picture would take half of this one for its own
        throw;
    }
    const auto header = bands_.front().header();
    out.insert(out.end(), header.begin(), header.end());
    std::size_t piece = 0;
    for (const JpegBand& band : bands_) piece = band.append(piece, out);
    out.back() = end_of_image; // in place of the last piece's restart
}

} // namespace ciel::wire
