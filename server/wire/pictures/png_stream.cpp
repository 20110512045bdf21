#include "wire/pictures/png_stream.hpp"

#include "wire/pictures/libpng_file.hpp"

#include <array>
#include <zlib.h>

namespace server::wire {
namespace {

constexpr png_byte idat[] = {'I', 'D', 'A', 'T', 0}, iend[] = {'I', 'E', 'N', 'D', 0};
constexpr std::array<png_byte, 2> zlib_header{0x78, 0x01}; // RFC 1950: deflate, window of 32 KiB, fastest level
constexpr std::array<png_byte, 2> last_block{0x03, 0x00};  // RFC 1951: an empty last block of the stream

std::uint32_t checksum_of(const std::vector<PngBand>& bands) {
    uLong sum = adler32(0, nullptr, 0);
    for (const PngBand& band : bands) sum = adler32_combine(sum, band.checksum(), static_cast<z_off_t>(band.bytes()));
    return static_cast<std::uint32_t>(sum);
}

void write_bands(png_structp png, png_infop info, const void* what) {
    const auto& bands = *static_cast<const std::vector<PngBand>*>(what);
    png_write_info(png, info);
    png_write_chunk(png, idat, zlib_header.data(), zlib_header.size());
    for (const PngBand& band : bands) png_write_chunk(png, idat, band.deflated().data(), band.deflated().size());
    std::array<png_byte, 6> end{last_block[0], last_block[1]};
    png_save_uint_32(end.data() + 2, checksum_of(bands));
    png_write_chunk(png, idat, end.data(), end.size());
    png_write_chunk(png, iend, nullptr, 0);
}

} // namespace

void PngStream::encode(int width, int height, std::span<const std::uint8_t> rgb, std::vector<std::uint8_t>& out) {
    check_picture("PNG", 1 << 24, width, height, rgb);
    const std::vector<PngBand>& bands = bands_.encode(width, height, rgb);
    write_with_libpng(width, height, out, write_bands, &bands);
}

} // namespace server::wire
