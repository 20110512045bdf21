// Makes one frame: takes the newest scene, extracts, draws, encodes and sends.
#pragma once

#include "engine/schedule/frame_workers.hpp"
#include "engine/view.hpp"

namespace ciel::engine {

// If a frame of `view` is due, makes the frame on this worker and sends it. `still`: whether to make a still picture
// instead of an interactive frame.
void show_frame(View& view, Worker& worker, bool still);

} // namespace ciel::engine
