// Draws geometry to an image and encodes the image.
#pragma once

#include "geometry/geometry.hpp"
#include "geometry/view_size.hpp"
#include "limits/limits.hpp"
#include "render/renderer.hpp"
#include "scene/scene.hpp"
#include "wire/frame_header.hpp"
#include "wire/pictures/picture_stream.hpp"

namespace ciel::frames {

inline constexpr int default_still_samples = 4; // samples per pixel of a still picture, for smooth edges

// Throws limits::LimitReached if a picture of that size exceeds the limits.
void check_picture_size(const limits::Limits& limits, std::int64_t width, std::int64_t height);
// Draws a picture without annotations, because the client draws the annotations itself. The renderer owns the returned
// picture, which is valid until the next draw call. Without `moving_scale`, draws a still picture of size `size` with
// `still_samples` samples per pixel. With `moving_scale`, draws an interactive picture with one sample per pixel; its
// width, height and line widths are multiplied by `moving_scale`. `check_wanted`: see render::Frame. Throws Error, and
// the exceptions of `check_wanted`.
[[nodiscard]] const render::Image& draw(const geometry::Geometry& geometry, const scene::Scene& scene,
                                        geometry::ViewSize size, std::optional<double> moving_scale,
                                        render::Renderer& renderer, int still_samples,
                                        const std::function<void()>& check_wanted);
// Returns the frame of a picture that is saved to a file: a still picture with annotations. Widths of lines and points
// grow in proportion to the text.
[[nodiscard]] render::Frame picture_of(const geometry::Geometry& geometry, const scene::Scene& scene,
                                       geometry::ViewSize size, int samples = default_still_samples);
// Returns one sentence for each part of the scene that the last picture of the renderer leaves out or shows only
// partly.
[[nodiscard]] std::vector<std::string> remarks_on(const geometry::Geometry& geometry, const render::Renderer& renderer);
// Returns the message of a picture: the header, then the encoded image. `moving` encodes the image; if `moving` is
// null, the image is a PNG. Sets the encoding time, sizes and flags in `header`.
[[nodiscard]] std::vector<std::uint8_t> image_message(wire::FrameHeader& header, const render::Image& image,
                                                      wire::PictureStream* moving);
// Writes the frame number into a finished message. The number is known only when the frame is sent.
void number_frame(std::vector<std::uint8_t>& message, std::uint32_t frame);

} // namespace ciel::frames
