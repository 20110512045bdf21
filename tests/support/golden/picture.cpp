#include "support/golden/picture.hpp"

#include <png.h>
#include <stdexcept>

namespace ciel::test {

Picture read_png(const std::filesystem::path& file) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    const auto fail = [&] { throw std::runtime_error(file.string() + ": " + image.message); };
    if (png_image_begin_read_from_file(&image, file.c_str()) == 0) fail();
    image.format = PNG_FORMAT_RGB;
    Picture picture{static_cast<int>(image.width), static_cast<int>(image.height), {}};
    picture.rgb.resize(PNG_IMAGE_SIZE(image));
    if (png_image_finish_read(&image, nullptr, picture.rgb.data(), 0, nullptr) == 0) fail();
    return picture;
}

void write_png(const std::filesystem::path& file, const Picture& picture) {
    std::filesystem::create_directories(file.parent_path());
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(picture.width);
    image.height = static_cast<png_uint_32>(picture.height);
    image.format = PNG_FORMAT_RGB;
    if (png_image_write_to_file(&image, file.c_str(), 0, picture.rgb.data(), 0, nullptr) == 0)
        throw std::runtime_error(file.string() + ": " + image.message);
}

} // namespace ciel::test
