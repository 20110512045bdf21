// Rows of a JPEG picture, coded apart from all others (T.81, E.1.4: nothing is predicted across a restart).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace ciel::wire {

class JpegBand {
public:
    static constexpr int most_rows = 64; // of pixels

    // The band from row `top` of pictures of this size, of a quality from 1 to 100. Throws Error where libjpeg does not
    // start.
    JpegBand(int width, int height, int top, int quality);
    ~JpegBand();
    JpegBand(JpegBand&&) noexcept;
    JpegBand& operator=(JpegBand&&) noexcept;

    // Codes the pieces that differ from those of the call before. `rgb`: the whole picture. After an error, which is
    // thrown, no other call is allowed.
    void encode(std::span<const std::uint8_t> rgb);
    // SOI to SOS, for the whole picture. Only after encode, of a band that had to code something.
    [[nodiscard]] std::span<const std::uint8_t> header() const { return header_; }
    // The pieces, each with the restart marker of its number after it. `number`: of the first; returns the one after
    // the last.
    std::size_t append(std::size_t number, std::vector<std::uint8_t>& out) const;

private:
    struct Libjpeg;
    struct Span { // columns of pieces
        int begin, end;
    };

    [[nodiscard]] Span changed(std::span<const std::uint8_t> rgb);
    void take(std::span<const std::uint8_t> file, Span span);

    int width_, height_, top_, quality_;
    int rows_;        // of pixels
    int piece_width_; // pixels
    int columns_;     // of pieces
    bool is_first_ = true;
    std::vector<std::uint8_t> last_;                // pixels of the call before
    std::vector<std::vector<std::uint8_t>> pieces_; // coded, without markers; rows from the top
    std::vector<std::uint8_t> header_;
    std::unique_ptr<Libjpeg> libjpeg_;
};

} // namespace ciel::wire
