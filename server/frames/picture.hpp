// Draws geometry to an image and encodes the image.
#pragma once

#include "geometry/geometry.hpp"
#include "geometry/view_size.hpp"
#include "limits/limits.hpp"
#include "render/renderer.hpp"
#include "scene/checked_scene.hpp"
#include "wire/frame_header.hpp"
#include "wire/pictures/picture_stream.hpp"

namespace server::frames {

inline constexpr int default_still_samples = 4; // samples per pixel of a still picture, for smooth edges

// Throws limits::LimitReached if a picture of that size exceeds the limits.
void check_picture_size(const limits::Limits& limits, std::int64_t width, std::int64_t height);
// Draws a picture without annotations, because the client draws them. The renderer owns the picture, which is valid
// until the next draw call. Without `moving_scale`, draws a still picture with `still_samples` samples per pixel. With
// `moving_scale`, draws an interactive picture with one sample per pixel. Its size and line widths are multiplied by
// `moving_scale`. Throws Error, and the exceptions of `check_wanted` (render::Frame).
[[nodiscard]] const render::Image& draw(const geometry::Geometry& geometry, const scene::CheckedScene& checked,
                                        geometry::ViewSize size, std::optional<double> moving_scale,
                                        render::Renderer& renderer, int still_samples,
                                        const std::function<void()>& check_wanted);
// Returns a still picture with annotations, for a file. Widths of lines and points grow in proportion to the text.
[[nodiscard]] render::Frame picture_of(const geometry::Geometry& geometry, const scene::CheckedScene& checked,
                                       geometry::ViewSize size, int samples = default_still_samples);
// Returns one sentence for each item of the scene that the last picture leaves out or shows only partly.
[[nodiscard]] std::vector<std::string> remarks_on(const geometry::Geometry& geometry, const render::Renderer& renderer);
// Returns the message of an image frame. Encodes the image with `moving`, or as PNG if `moving` is null. Sets the
// encoding time, sizes and flags in `header`.
[[nodiscard]] std::vector<std::uint8_t> image_message(wire::FrameHeader& header, const render::Image& image,
                                                      wire::PictureStream* moving);
// Writes the frame number into a finished message. The number is known only when the frame is sent.
void number_frame(std::vector<std::uint8_t>& message, std::uint32_t frame);

} // namespace server::frames
