#include "vs_vtk_render/jpeg.hpp"

#include <cstdio> // must precede jpeglib.h, which needs FILE
#include <jpeglib.h>

namespace ciel::vs_vtk {

void encode_jpeg(int width, int height, std::span<const std::uint8_t> rows_from_bottom,
                 std::vector<std::uint8_t>& out) {
    constexpr int quality = 80;
    jpeg_compress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    // More than any JPEG of this size needs.
    out.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    unsigned char* begin = out.data();
    unsigned long size = out.size();
    jpeg_mem_dest(&jpeg, &begin, &size);
    jpeg.image_width = static_cast<JDIMENSION>(width);
    jpeg.image_height = static_cast<JDIMENSION>(height);
    jpeg.input_components = 4;
    jpeg.in_color_space = JCS_EXT_RGBX;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, quality, TRUE);
    jpeg_start_compress(&jpeg, TRUE);
    for (int row = height - 1; row >= 0; --row) {
        auto* line = const_cast<JSAMPROW>(rows_from_bottom.data() + 4 * std::ptrdiff_t{width} * row); // read only
        jpeg_write_scanlines(&jpeg, &line, 1);
    }
    jpeg_finish_compress(&jpeg);
    jpeg_destroy_compress(&jpeg);
    out.resize(size);
}

} // namespace ciel::vs_vtk
