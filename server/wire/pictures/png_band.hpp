// A band of rows of a PNG picture, filtered and deflated independently of all other bands.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace server::wire {

class PngBand {
public:
    static constexpr int most_rows = 32;

    // Makes the band that begins at pixel row `top` of pictures of this size.
    PngBand(int width, int height, int top);

    // Encodes the band if its pixels differ from the previous call. `rgb`: the whole picture. Throws Error.
    void encode(std::span<const std::uint8_t> rgb);

    // Returns deflate blocks that end at a byte boundary. No block is marked as the last of the stream.
    [[nodiscard]] std::span<const std::uint8_t> deflated() const { return deflated_; }
    [[nodiscard]] std::uint32_t checksum() const { return checksum_; }        // Adler-32 of the filtered rows
    [[nodiscard]] std::size_t bytes() const { return rows_ * (stride_ + 1); } // size of the filtered rows

private:
    std::size_t stride_; // bytes of a row of pixels
    std::size_t rows_, top_;
    std::vector<std::uint8_t> last_; // pixels of the previous picture
    std::vector<std::uint8_t> deflated_;
    std::uint32_t checksum_ = 0;
};

} // namespace server::wire
