#include "wire/pictures/jpeg_band.hpp"

#include "ciel/types.hpp"

#include <algorithm>
#include <csetjmp>
#include <cstdio> // before jpeglib.h, which needs FILE
#include <cstring>
#include <jpeglib.h>
#include <new>
#include <string>
#include <utility>

namespace server::wire {
namespace {

constexpr int unit = 16;        // pixels per side of an MCU (minimum coded unit), with libjpeg's default sampling
constexpr int wished_units = 4; // fewest MCUs in a piece

// Returns a divisor of units_of_row, so that every row of MCUs ends at the end of a restart interval.
int units_of_piece(int units_of_row) {
    for (int units = wished_units; units <= 3 * wished_units; ++units)
        if (units_of_row % units == 0) return units;
    return units_of_row;
}

constexpr std::uint8_t mark = 0xFF, frame_start = 0xC0, scan_start = 0xDA, first_restart = 0xD0, end_of_image = 0xD9;

bool is_restart(const std::uint8_t* at) { return at[0] == mark && at[1] >= first_restart && at[1] < end_of_image - 1; }

} // namespace

// libjpeg reports errors by longjmp; no object with a destructor may live between setjmp and longjmp.
struct JpegBand::Libjpeg {
    jpeg_compress_struct compress{};
    jpeg_error_mgr errors{};
    std::jmp_buf failed{};
    std::vector<std::uint8_t> file;

    Libjpeg() {
        compress.err = jpeg_std_error(&errors);
        compress.client_data = this;
        errors.error_exit = [](j_common_ptr info) {
            std::longjmp(static_cast<Libjpeg*>(info->client_data)->failed, 1);
        };
        errors.output_message = [](j_common_ptr) {};
        if (setjmp(failed) != 0) fail();
        jpeg_create_compress(&compress);
    }
    ~Libjpeg() { jpeg_destroy_compress(&compress); }
    Libjpeg(const Libjpeg&) = delete;
    Libjpeg& operator=(const Libjpeg&) = delete;

    [[noreturn]] void fail() {
        std::array<char, JMSG_LENGTH_MAX> sentence{};
        errors.format_message(reinterpret_cast<j_common_ptr>(&compress), sentence.data());
        jpeg_abort_compress(&compress);
        throw ciel::Error(std::string("libjpeg could not write a picture: ") + sentence.data());
    }

    // Writes a restart marker after every `units` MCUs. The result is valid until the next call.
    std::span<const std::uint8_t> encode(const std::uint8_t* first, std::size_t stride, int width, int height,
                                         int units, int quality) {
        file.resize(4 * static_cast<std::size_t>(width + unit) * static_cast<std::size_t>(height + unit) + 1024);
        unsigned char* begin = file.data();
        unsigned long size = file.size();
        if (setjmp(failed) != 0) fail();
        jpeg_mem_dest(&compress, &begin, &size);
        compress.image_width = static_cast<JDIMENSION>(width);
        compress.image_height = static_cast<JDIMENSION>(height);
        compress.input_components = 3;
        compress.in_color_space = JCS_RGB;
        jpeg_set_defaults(&compress);
        jpeg_set_quality(&compress, quality, TRUE);
        compress.restart_interval = static_cast<unsigned>(units);
        jpeg_start_compress(&compress, TRUE);
        for (int row = 0; row < height; ++row) {
            // libjpeg needs a non-const row, but only reads it.
            JSAMPROW line = const_cast<JSAMPROW>(first + static_cast<std::size_t>(row) * stride);
            jpeg_write_scanlines(&compress, &line, 1);
        }
        jpeg_finish_compress(&compress);
        return {begin, size};
    }
};

JpegBand::JpegBand(int width, int height, int top, int quality)
    : width_(width), height_(height), top_(top), quality_(quality), rows_(std::min(most_rows, height - top)),
      piece_width_(unit * units_of_piece((width + unit - 1) / unit)),
      columns_((width + piece_width_ - 1) / piece_width_),
      last_(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(rows_)),
      pieces_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>((rows_ + unit - 1) / unit)),
      libjpeg_(std::make_unique<Libjpeg>()) {}

JpegBand::~JpegBand() = default;
JpegBand::JpegBand(JpegBand&&) noexcept = default;
JpegBand& JpegBand::operator=(JpegBand&&) noexcept = default;

JpegBand::Span JpegBand::changed(std::span<const std::uint8_t> rgb) {
    const std::size_t stride = 3 * static_cast<std::size_t>(width_);
    const std::size_t piece = 3 * static_cast<std::size_t>(piece_width_);
    const auto first = rgb.subspan(static_cast<std::size_t>(top_) * stride, last_.size());
    std::size_t begin = stride, end = 0; // changed byte range of the rows
    for (std::size_t row = 0; row < first.size(); row += stride) {
        const std::uint8_t *now = first.data() + row, *then = last_.data() + row;
        for (std::size_t at = 0; at < stride; at += piece) {
            if (at >= begin && at < end) continue;
            if (std::memcmp(now + at, then + at, std::min(piece, stride - at)) == 0) continue;
            begin = std::min(begin, at);
            end = std::max(end, at + piece);
        }
    }
    if (std::exchange(is_first_, false)) begin = 0, end = stride;
    if (begin < end) std::ranges::copy(first, last_.begin());
    return {static_cast<int>(begin / piece), static_cast<int>((end + piece - 1) / piece)};
}

void JpegBand::encode(std::span<const std::uint8_t> rgb) {
    const Span span = changed(rgb);
    if (span.begin >= span.end) return;
    const int left = span.begin * piece_width_, right = std::min(span.end * piece_width_, width_);
    take(libjpeg_->encode(last_.data() + 3 * static_cast<std::size_t>(left), 3 * static_cast<std::size_t>(width_),
                          right - left, rows_, piece_width_ / unit, quality_),
         span);
}

void JpegBand::take(std::span<const std::uint8_t> file, Span span) {
    // Skips SOI. A segment begins with a mark, its kind, and its length in two bytes.
    const std::uint8_t* at = file.data() + 2;
    const std::uint8_t* frame = nullptr;
    for (bool is_last = false; !is_last; at += 2 + 256 * at[2] + at[3]) {
        if (at[1] == frame_start) frame = at;
        is_last = at[1] == scan_start;
    }
    if (header_.empty() && top_ == 0) {
        header_.assign(file.data(), at);
        std::uint8_t* size = header_.data() + (frame - file.data()) + 5; // height and width, two bytes each
        size[0] = static_cast<std::uint8_t>(height_ >> 8), size[1] = static_cast<std::uint8_t>(height_);
        size[2] = static_cast<std::uint8_t>(width_ >> 8), size[3] = static_cast<std::uint8_t>(width_);
    }
    const std::uint8_t* end = file.data() + file.size() - 2; // without the EOI marker
    for (std::size_t row = 0; row < pieces_.size(); row += static_cast<std::size_t>(columns_))
        for (int column = span.begin; column < span.end; ++column) {
            const std::uint8_t* from = at;
            while (at < end && !is_restart(at)) {
                const void* next = std::memchr(at + 1, mark, static_cast<std::size_t>(end - at - 1));
                at = next != nullptr ? static_cast<const std::uint8_t*>(next) : end;
            }
            pieces_[row + static_cast<std::size_t>(column)].assign(from, at);
            at = std::min(at + 2, end);
        }
}

std::size_t JpegBand::append(std::size_t number, std::vector<std::uint8_t>& out) const {
    for (const std::vector<std::uint8_t>& piece : pieces_) {
        out.insert(out.end(), piece.begin(), piece.end());
        out.push_back(mark);
        out.push_back(static_cast<std::uint8_t>(first_restart + number++ % 8));
    }
    return number;
}

} // namespace server::wire
