#include "frames/picture.hpp"

#include "frames/frame_of.hpp"
#include "geometry/scene_annotations.hpp"
#include "geometry/viewpoint.hpp"
#include "limits/errors.hpp"
#include "wire/pictures/png.hpp"

#include <chrono>

namespace server::frames {
namespace {

void widen_lines(render::Frame& frame, double times) {
    for (render::Primitives& primitives : frame.primitives)
        primitives.line_width = primitives.point_size = primitives.line_width * static_cast<float>(times);
}
} // namespace

void check_picture_size(const limits::Limits& limits, std::int64_t width, std::int64_t height) {
    if (static_cast<std::uint64_t>(std::max(width, height)) > limits.image_side)
        throw limits::LimitReached("a picture may be at most " + std::to_string(limits.image_side) +
                                   " pixels wide and high; ask for a smaller picture");
    if (static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) > limits.image_pixels)
        throw limits::LimitReached("a picture may have at most " + std::to_string(limits.image_pixels) +
                                   " pixels; ask for a smaller picture");
}

const render::Image& draw(const geometry::Geometry& geometry, const scene::CheckedScene& checked,
                          geometry::ViewSize size, std::optional<double> moving_scale, render::Renderer& renderer,
                          int still_samples, const std::function<void()>& check_wanted) {
    const double scale = moving_scale.value_or(1);
    const int width = std::max(1, static_cast<int>(size.width * scale));
    const int height = std::max(1, static_cast<int>(size.height * scale));
    render::Frame frame = frame_of(geometry, checked, width, height, moving_scale ? 1 : still_samples);
    // The default camera depends on the size. A smaller interactive picture uses the camera of the still picture.
    if (!checked.scene().camera && scale < 1)
        frame.camera =
            geometry::default_view(geometry, checked, static_cast<int>(size.width), static_cast<int>(size.height));
    widen_lines(frame, size.pixel_ratio * scale);
    frame.check_wanted = check_wanted;
    return renderer.draw(frame);
}

render::Frame picture_of(const geometry::Geometry& geometry, const scene::CheckedScene& checked,
                         geometry::ViewSize size, int samples) {
    render::Frame frame =
        frame_of(geometry, checked, static_cast<int>(size.width), static_cast<int>(size.height), samples);
    widen_lines(frame, std::max(1.0, annotations::size_of_picture(frame.width, frame.height)));
    frame.annotations = geometry::annotations_of(geometry, checked);
    return frame;
}

std::vector<std::string> remarks_on(const geometry::Geometry& geometry, const render::Renderer& renderer) {
    std::vector<std::string> remarks = geometry.lacking;
    remarks.insert(remarks.end(), geometry.remarks.begin(), geometry.remarks.end());
    for (const geometry::EmptyLayer& empty : geometry.empty) {
        if (empty.why == geometry::EmptyLayer::Why::missing) continue; // already in `lacking`
        remarks.push_back("layer " + empty.layer + " shows nothing. " + empty.reason);
    }
    remarks.insert(remarks.end(), renderer.remarks().begin(), renderer.remarks().end());
    return remarks;
}

std::vector<std::uint8_t> image_message(wire::FrameHeader& header, const render::Image& image,
                                        wire::PictureStream* moving) {
    using Clock = std::chrono::steady_clock;
    const auto started = Clock::now();
    std::vector<std::uint8_t> message(wire::frame_header_bytes);
    if (moving != nullptr)
        moving->encode(image.width, image.height, image.rgb, message);
    else
        wire::encode_png(image.width, image.height, image.rgb, message);
    header.encode_ms = std::chrono::duration<float, std::milli>(Clock::now() - started).count();
    header.flags |= wire::first_of_frame | wire::last_of_frame;
    header.width = static_cast<std::uint32_t>(image.width);
    header.height = static_cast<std::uint32_t>(image.height);
    header.payload_bytes = header.whole_bytes = static_cast<std::uint32_t>(message.size() - wire::frame_header_bytes);
    wire::write_frame_header(
        header, std::span<std::uint8_t, wire::frame_header_bytes>(message.data(), wire::frame_header_bytes));
    return message;
}

void number_frame(std::vector<std::uint8_t>& message, std::uint32_t frame) {
    const std::span<std::uint8_t, wire::frame_header_bytes> bytes(message.data(), wire::frame_header_bytes);
    wire::FrameHeader header = wire::read_frame_header(message);
    header.frame = frame;
    wire::write_frame_header(header, bytes);
}

} // namespace server::frames
