// The spine: newest scene -> extract -> draw -> encode -> send.
#pragma once

#include "engine/schedule/frame_workers.hpp"
#include "engine/view.hpp"

namespace ciel::engine {

// One frame of `view` on this worker, if one is due.
void show_frame(View& view, Worker& worker, bool still);

} // namespace ciel::engine
