// Progress and cancelling: one line on standard output per percent or phase, in the form the supervisor parses.
#pragma once

#include <string>

namespace ciel::importer {

// Thrown by progress() after SIGINT or SIGTERM. Unwinding removes the unfinished dataset.
struct Cancelled {};

// From now on SIGINT and SIGTERM make progress() throw.
void install_cancel_handlers();

// From now on progress() does not throw, even if a signal has already arrived. Call when the dataset is complete.
void ignore_cancelling();

// Prints "progress SHARE PHASE" if the percentage grew or the phase changed; SHARE in [0, 1]. A reader that starts over
// prints nothing until it gets further than before, so that the supervisor sees that the import stalls. Throws
// Cancelled after a signal.
void progress(double share, const std::string& phase);

} // namespace ciel::importer
