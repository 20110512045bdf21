// Rows of a PNG picture, filtered and deflated apart from all others.
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

    // Codes the rows where they differ from those of the call before. `rgb`: the whole picture. Throws Error.
    void encode(std::span<const std::uint8_t> rgb);

    // Deflate blocks up to a whole byte, none of them the last of the stream.
    [[nodiscard]] std::span<const std::uint8_t> deflated() const { return deflated_; }
    [[nodiscard]] std::uint32_t checksum() const { return checksum_; }        // Adler-32 of what was deflated
    [[nodiscard]] std::size_t bytes() const { return rows_ * (stride_ + 1); } // before they were deflated

private:
    std::size_t stride_; // bytes of a row of pixels
    std::size_t rows_, top_;
    std::vector<std::uint8_t> last_; // pixels of the call before
    std::vector<std::uint8_t> deflated_;
    std::uint32_t checksum_ = 0;
};

} // namespace ciel::wire
