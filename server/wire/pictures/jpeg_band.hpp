// A band of rows of a JPEG picture. A band consists of pieces, and each piece ends at a restart marker
// (jpeg_stream.hpp). A band is encoded independently of all other bands, because nothing is predicted across a restart
// (T.81, E.1.4).
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
    static constexpr int most_rows = 64; // pixel rows

    // Makes the band that begins at pixel row `top` of pictures of this size. `quality`: 1 to 100. Throws Error if
    // libjpeg cannot be set up.
    JpegBand(int width, int height, int top, int quality);
    ~JpegBand();
    JpegBand(JpegBand&&) noexcept;
    JpegBand& operator=(JpegBand&&) noexcept;

    // Encodes the columns of pieces that differ from the previous call. `rgb`: the whole picture. After an Error no
    // further call is allowed.
    void encode(std::span<const std::uint8_t> rgb);
    // Returns the file header of the whole picture, from SOI to SOS. Valid after encode, and only in the band at row 0;
    // empty in other bands.
    [[nodiscard]] std::span<const std::uint8_t> header() const { return header_; }
    // Appends the encoded pieces, each followed by its restart marker. `number`: index of the first piece in the
    // picture. Returns the index after the last piece.
    std::size_t append(std::size_t number, std::vector<std::uint8_t>& out) const;

private:
    struct Libjpeg;
    struct Span { // half-open range of columns of pieces
        int begin, end;
    };

    [[nodiscard]] Span changed(std::span<const std::uint8_t> rgb);
    void take(std::span<const std::uint8_t> file, Span span);

    int width_, height_, top_, quality_;
    int rows_;        // pixel rows of this band
    int piece_width_; // pixels
    int columns_;     // pieces per row
    bool is_first_ = true;
    std::vector<std::uint8_t> last_;                // pixels of the previous picture
    std::vector<std::vector<std::uint8_t>> pieces_; // encoded pieces without markers; rows from the top
    std::vector<std::uint8_t> header_;
    std::unique_ptr<Libjpeg> libjpeg_;
};

} // namespace ciel::wire
