#include "frames/test_picture.hpp"

#include <cstdlib>

namespace server::frames {
namespace {

constexpr int size = 32;
constexpr std::array<int, 3> orange{255, 128, 0}; // drawn without lighting, so that the pixels have this color

bool close(const std::uint8_t* pixel, const std::array<int, 3>& color) {
    for (std::size_t i = 0; i < 3; ++i)
        if (std::abs(pixel[i] - color[i]) > 2) return false;
    return true;
}

} // namespace

bool is_test_picture(const render::Image& image) {
    const std::size_t middle = std::size_t{3} * (size / 2 * size + size / 2);
    return image.rgb.size() == std::size_t{3} * size * size && close(&image.rgb[middle], orange) &&
           !close(image.rgb.data(), orange);
}

TestPictureResult draw_test_picture(render::Renderer& renderer) {
    // The triangle covers the middle of the picture, but not its corners.
    const std::vector<ciel::Vec3f> positions{{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}};
    const std::vector<ciel::Index> indices{0, 1, 2};
    render::Frame frame;
    frame.width = frame.height = size;
    frame.camera = {{0, -4, 0}, {0, 0, 0}, {0, 0, 1}, 45, false, 1};
    frame.bounds_min = {-1, -0.1, -1};
    frame.bounds_max = {1, 0.1, 1};
    render::Primitives primitives;
    primitives.positions = positions;
    primitives.indices = indices;
    primitives.lit = false;
    primitives.color = {1, 128.0F / 255, 0, 1};
    frame.primitives.push_back(primitives);
    render::Image image;
    renderer.draw(frame, image);

    TestPictureResult result;
    result.gl_renderer = renderer.gl_renderer();
    result.gl_version = renderer.gl_version();
    result.backend = render::name_of(renderer.backend());
    result.passed = is_test_picture(image);
    if (!result.passed) {
        result.problem =
            result.gl_renderer + " drew a test picture with wrong pixels; choose another back end with --gl";
        return result;
    }
    frame.width = 1280; // size of a usual still picture, for the memory check
    frame.height = 720;
    frame.samples = 4;
    try {
        renderer.check_memory(frame);
    } catch (const ciel::Error& error) {
        result.passed = false;
        result.problem = error.what();
    }
    return result;
}

} // namespace server::frames
