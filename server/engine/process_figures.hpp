// What the process uses, by the names that Prometheus' own client libraries give it.
// https://prometheus.io/docs/instrumenting/writing_clientlibs/#standard-and-runtime-collectors
#pragma once

#include <ostream>

namespace ciel::engine {

// Lines of the text exposition format 0.0.4. A figure that the system does not tell is left out. Thread-safe.
void write_process_figures(std::ostream& out);

} // namespace ciel::engine
