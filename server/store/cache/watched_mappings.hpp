// Keeps the process alive when a mapped file shrinks. The first access behind the file's new end raises SIGBUS. The
// signal handler maps zeros over the whole mapping, so that readers go on with harmless values. It also marks the
// mapping as lost, so that results made from it are discarded. A mapping is lost too when a reader finds that its
// content has changed since it was opened.
#pragma once

#include <atomic>
#include <cstddef>

namespace ciel::store {

struct WatchedMapping;

enum class Loss { none, shrunk, changed };

// Watches the mapping [data, data + bytes). The first call installs the SIGBUS handler; for other addresses the handler
// passes the signal on to the previous one. `any_lost` is set when the mapping is lost, and must live until
// unwatch_mapping. Call unwatch_mapping before munmap. Thread-safe.
[[nodiscard]] WatchedMapping* watch_mapping(void* data, std::size_t bytes, std::atomic<bool>& any_lost);
void unwatch_mapping(WatchedMapping* mapping);
[[nodiscard]] Loss loss_of(const WatchedMapping& mapping);
void note_change(WatchedMapping& mapping); // marks the mapping as lost: Loss::changed
// Returns the number of lost mappings of the process that are still watched.
[[nodiscard]] std::size_t lost_mapping_count();

} // namespace ciel::store
