// Resource use of the process as metrics, under the names that Prometheus' own client libraries use.
// https://prometheus.io/docs/instrumenting/writing_clientlibs/#standard-and-runtime-collectors
#pragma once

#include <ostream>

namespace server::engine {

// Writes the text exposition format 0.0.4. Leaves out values that the system does not provide. Thread-safe.
void write_process_figures(std::ostream& out);

} // namespace server::engine
