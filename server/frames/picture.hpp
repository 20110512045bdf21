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

inline constexpr int default_still_samples = 4; // samples per pixel of a still; makes edges smooth, also in software

// Throws limits::LimitReached if a picture of that size exceeds the limits.
void check_picture_size(const limits::Limits& limits, std::int64_t width, std::int64_t height);
// Draws a picture without annotations. It belongs to the renderer and is valid until its next draw. Without
// `moving_scale` it is a still of the requested size with `still_samples` per pixel. An interactive picture is
// `moving_scale` times as large, with one sample per pixel and lines that are thinner by the same factor. The client
// draws the annotations itself, at the screen's resolution and without waiting for a frame. `check_wanted`: see
// render::Frame. Throws Error, and what check_wanted throws.
[[nodiscard]] const render::Image& draw(const geometry::Geometry& geometry, const scene::Scene& scene,
                                        geometry::ViewSize size, std::optional<double> moving_scale,
                                        render::Renderer& renderer, int still_samples,
                                        const std::function<void()>& check_wanted);
// Returns the frame of a standalone picture (a file): a still with annotations. Lines and points grow with the text.
[[nodiscard]] render::Frame picture_of(const geometry::Geometry& geometry, const scene::Scene& scene,
                                       geometry::ViewSize size, int samples = default_still_samples);
// Returns one sentence per part of the scene that the renderer's last picture leaves out or shows only in part.
[[nodiscard]] std::vector<std::string> remarks_on(const geometry::Geometry& geometry, const render::Renderer& renderer);
// Returns the message of a picture: the header, and the image encoded by `moving`, or as PNG if `moving` is null. Fills
// in the header's encoding time, sizes and flags.
[[nodiscard]] std::vector<std::uint8_t> image_message(wire::FrameHeader& header, const render::Image& image,
                                                      wire::PictureStream* moving);
// Writes the frame number into a finished message. The number is known only when the frame is sent.
void number_frame(std::vector<std::uint8_t>& message, std::uint32_t frame);

} // namespace ciel::frames
