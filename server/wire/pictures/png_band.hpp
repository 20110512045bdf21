// Rows of a PNG picture, filtered and deflated independently of all others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ciel::wire {

class PngBand {
public:
    static constexpr int most_rows = 32;

    PngBand(int width, int height, int top); // the band from row `top` of pictures of this size

    // Encodes the band if it differs from the previous call. `rgb`: the whole picture. Throws Error.
    void encode(std::span<const std::uint8_t> rgb);

    // Deflate blocks, ending at a byte boundary; none is marked as the last of the stream.
    [[nodiscard]] std::span<const std::uint8_t> deflated() const { return deflated_; }
    [[nodiscard]] std::uint32_t checksum() const { return checksum_; }        // Adler-32 of the uncompressed bytes
    [[nodiscard]] std::size_t bytes() const { return rows_ * (stride_ + 1); } // uncompressed

private:
    std::size_t stride_; // bytes of a row of pixels
    std::size_t rows_, top_;
    std::vector<std::uint8_t> last_; // pixels of the previous call
    std::vector<std::uint8_t> deflated_;
    std::uint32_t checksum_ = 0;
};

} // namespace ciel::wire
