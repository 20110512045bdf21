// Makes one frame: takes the newest scene, extracts, draws, encodes and sends.
#pragma once

#include "engine/schedule/frame_workers.hpp"
#include "engine/view.hpp"

namespace server::engine {

// Makes and sends a frame of `view` if one is due. `still`: makes a still picture instead of an interactive frame.
void show_frame(View& view, Worker& worker, bool still);

} // namespace server::engine
