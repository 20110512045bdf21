// A band of rows of a JPEG picture, in pieces that end at restart markers (jpeg_stream.hpp). Bands are independent,
// because nothing is predicted across a restart (T.81, E.1.4).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace server::wire {

class JpegBand {
public:
    static constexpr int most_rows = 64; // pixel rows

    // `top`: first pixel row. `quality`: 1 to 100. Throws Error if libjpeg cannot be set up.
    JpegBand(int width, int height, int top, int quality);
    ~JpegBand();
    JpegBand(JpegBand&&) noexcept;
    JpegBand& operator=(JpegBand&&) noexcept;

    // Encodes columns that differ from the previous call. `rgb`: the whole picture. Do not call it after an Error.
    void encode(std::span<const std::uint8_t> rgb);
    // Returns the file header from SOI to SOS, valid after encode; empty except in the band at row 0.
    [[nodiscard]] std::span<const std::uint8_t> header() const { return header_; }
    // Appends the pieces, each followed by a restart marker. `number`: index of the first piece in the picture. Returns
    // the index after the last piece.
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

} // namespace server::wire
