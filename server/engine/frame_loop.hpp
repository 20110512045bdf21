// Makes one frame: newest scene -> extract -> draw -> encode -> send.
#pragma once

#include "engine/schedule/frame_workers.hpp"
#include "engine/view.hpp"

namespace ciel::engine {

// Makes and sends one frame of `view` on this worker, if one is due. `still`: a still, else an interactive frame.
void show_frame(View& view, Worker& worker, bool still);

} // namespace ciel::engine
