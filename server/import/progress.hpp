// Progress and cancelling: one line on standard output per percent or phase, in the form the supervisor parses.
#pragma once

#include <string>

namespace ciel::importer {

// Thrown from progress() after SIGINT or SIGTERM: unwinding removes what was written aside.
struct Cancelled {};

// From now on SIGINT and SIGTERM make progress() throw.
void install_cancel_handlers();

// From now on progress() no longer throws: what was asked for stands, whether or not a signal comes, or came.
void ignore_cancelling();

// Prints "progress SHARE PHASE" when it has advanced: a reader that starts over again and again prints nothing, which
// is how the supervisor notices. SHARE in [0, 1].
void progress(double share, const std::string& phase);

} // namespace ciel::importer
