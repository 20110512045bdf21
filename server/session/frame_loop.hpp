// The spine: newest scene -> extract -> draw -> encode -> send.
#pragma once

#include "session/frame_workers.hpp"
#include "session/view.hpp"

namespace ciel::session {

// One frame of `view` on this worker, if one is due.
void show_frame(View& view, Worker& worker, bool still);

} // namespace ciel::session
