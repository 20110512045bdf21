// Rows of a JPEG picture, encoded independently of all others (T.81, E.1.4: nothing is predicted across a restart).
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

    // The band from row `top` of pictures of this size. quality: 1 to 100. Throws Error when libjpeg cannot be set up.
    JpegBand(int width, int height, int top, int quality);
    ~JpegBand();
    JpegBand(JpegBand&&) noexcept;
    JpegBand& operator=(JpegBand&&) noexcept;

    // Encodes the pieces that differ from the previous call. `rgb`: the whole picture. Throws Error; no call is allowed
    // after that.
    void encode(std::span<const std::uint8_t> rgb);
    // SOI to SOS of the whole picture. Valid after encode, in the band of row 0 only; empty in others.
    [[nodiscard]] std::span<const std::uint8_t> header() const { return header_; }
    // Appends the pieces, each followed by the restart marker of its number. `number`: of the first piece. Returns the
    // number after the last.
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
    std::vector<std::uint8_t> last_;                // pixels of the previous call
    std::vector<std::vector<std::uint8_t>> pieces_; // encoded, without markers; rows from the top
    std::vector<std::uint8_t> header_;
    std::unique_ptr<Libjpeg> libjpeg_;
};

} // namespace ciel::wire
