// Geometry -> image -> bytes.
#pragma once

#include "frames/still_samples.hpp"
#include "geometry/geometry.hpp"
#include "geometry/view_size.hpp"
#include "limits/limits.hpp"
#include "render/renderer.hpp"
#include "scene/scene.hpp"
#include "wire/frame_header.hpp"
#include "wire/pictures/picture_stream.hpp"

namespace ciel::frames {

// Throws LimitReached.
void check_picture_size(const limits::Limits& limits, std::int64_t width, std::int64_t height);
// A still has the asked size and `still_samples` a pixel; an interactive picture is `moving_scale` times as large and
// has one sample, and its lines are as much thinner. Neither is written on: who shows a view's frames draws the scene's
// annotations over them, at the screen's resolution and without waiting for a frame. The picture is the renderer's,
// until its next. `check_wanted` as the frame's. Throws Error, and what check_wanted throws.
[[nodiscard]] const render::Image& draw(const geometry::Geometry& geometry, const scene::Scene& scene,
                                        geometry::ViewSize size, std::optional<double> moving_scale,
                                        render::Renderer& renderer, int still_samples,
                                        const std::function<void()>& check_wanted);
// A picture that stands for itself, as a file does: a still with the scene's annotations. Lines and points
// grow as text does.
[[nodiscard]] render::Frame picture_of(const geometry::Geometry& geometry, const scene::Scene& scene,
                                       geometry::ViewSize size, int samples = default_still_samples);
// What a picture that this renderer has just drawn does not show, or not in full, a sentence each.
[[nodiscard]] std::vector<std::string> remarks_on(const geometry::Geometry& geometry, const render::Renderer& renderer);
// Header and picture, the next of `moving` or a PNG for good; fills in the header's encoding time, sizes and flags.
[[nodiscard]] std::vector<std::uint8_t> image_message(wire::FrameHeader& header, const render::Image& image,
                                                      wire::PictureStream* moving);
// Writes the frame number into a finished message: it is known only when the frame is sent.
void number_frame(std::vector<std::uint8_t>& message, std::uint32_t frame);

} // namespace ciel::frames
