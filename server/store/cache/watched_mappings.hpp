// Keeps the process alive when a file shrinks while it is mapped: the first touch behind its new end raises SIGBUS.
// The handler puts zeros in place of the whole mapping, so that its readers go on with harmless values, and notes that
// it is lost, so that nobody shows what was made of them. A mapping is lost too when a reader finds in it what was not
// there when it was opened.
#pragma once

#include <atomic>
#include <cstddef>

namespace ciel::store {

struct WatchedMapping;

enum class Loss { none, shrunk, changed };

// Watches [data, data + bytes), which mmap returned; the first call installs the handler, which passes on the SIGBUS of
// others. `any_lost` is set as soon as the mapping is lost; it is borrowed until unwatch. Thread-safe; a returned
// mapping must be given to unwatch before it is unmapped.
[[nodiscard]] WatchedMapping* watch_mapping(void* data, std::size_t bytes, std::atomic<bool>& any_lost);
void unwatch_mapping(WatchedMapping* mapping);
[[nodiscard]] Loss loss_of(const WatchedMapping& mapping);
void note_change(WatchedMapping& mapping); // it is lost
// Those of the whole process that are lost and still mapped.
[[nodiscard]] std::size_t lost_mapping_count();

} // namespace ciel::store
