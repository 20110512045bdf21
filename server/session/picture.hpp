// Geometry -> image -> bytes.
#pragma once

#include "session/frame_workers.hpp"
#include "session/limits.hpp"
#include "session/scene_geometry.hpp"
#include "session/view.hpp"
#include "wire/frame_header.hpp"

namespace ciel::session {

// Throws LimitReached.
void check_picture_size(const Limits& limits, std::int64_t width, std::int64_t height);
// A still has the asked size and the worker's samples a pixel; an interactive picture is so many times as large and has
// one sample, and its lines are as much thinner. Neither is written on: who shows a view's frames draws the scene's
// annotations over them, at the screen's resolution and without waiting for a frame. The picture is the worker's, until
// its next. `check_wanted` as the frame's.
[[nodiscard]] const render::Image& draw(const Geometry& geometry, const scene::Scene& scene, ViewSize size,
                                        std::optional<double> moving_scale, Worker& worker,
                                        const std::function<void()>& check_wanted);
// A picture that stands for itself, as a file does: a still with the scene's annotations. Lines and points
// grow as text does.
[[nodiscard]] render::Frame picture_of(const Geometry& geometry, const scene::Scene& scene, ViewSize size,
                                       int samples = default_still_samples);
// What a picture that this renderer has just drawn does not show, or not in full, a sentence each.
[[nodiscard]] std::vector<std::string> remarks_on(const Geometry& geometry, const render::Renderer& renderer);
// Header and picture, the next of `moving` or a PNG for good; fills in the header's encoding time, sizes and flags.
[[nodiscard]] std::vector<std::uint8_t> image_message(wire::FrameHeader& header, const render::Image& image,
                                                      wire::PictureStream* moving);
// Writes the frame number into a finished message: it is known only when the frame is sent.
void number_frame(std::vector<std::uint8_t>& message, std::uint32_t frame);

} // namespace ciel::session
