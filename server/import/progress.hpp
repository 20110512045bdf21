// Prints progress for the supervisor (importing/importer.hpp), and cancels the import after a signal.
#pragma once

#include <string>

namespace server::importer {

// progress() throws this after SIGINT or SIGTERM. Stack unwinding then removes the unfinished dataset.
struct Cancelled {};

void install_cancel_handlers();

// After this call, progress() never throws. Call it when the dataset is complete.
void ignore_cancelling();

// Prints "progress SHARE PHASE" if the phase changed or the percentage is larger than in the last line. `share` is in
// [0, 1]. If a reader restarts its progress at 0, nothing is printed until `share` is larger than before, so that the
// supervisor can notice a stall. Throws Cancelled after SIGINT or SIGTERM.
void progress(double share, const std::string& phase);

} // namespace server::importer
