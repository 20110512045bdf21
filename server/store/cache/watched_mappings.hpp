// Keeps the process alive when a mapped file shrinks and an access behind the new end of the file raises SIGBUS. The
// signal handler maps zeroed memory over the memory page of this access; after many such accesses, over the whole file.
// It marks the mapping as lost, so that results from it are discarded. A mapping is also marked as lost when a reader
// detects that its content has changed.
#pragma once

#include <atomic>
#include <cstddef>

namespace server::store {

struct WatchedMapping;

enum class Loss { none, shrunk, changed };

// Watches the mapping [data, data + bytes). The first call installs the SIGBUS handler. If the address of a SIGBUS is
// in no watched mapping, the previous handler gets the signal. `losses` is incremented when the mapping is lost, and
// must exist until unwatch_mapping. Call unwatch_mapping before munmap. Thread-safe.
[[nodiscard]] WatchedMapping* watch_mapping(void* data, std::size_t bytes, std::atomic<std::uint32_t>& losses);
void unwatch_mapping(WatchedMapping* mapping);
[[nodiscard]] Loss loss_of(const WatchedMapping& mapping);
void note_loss(WatchedMapping& mapping, Loss loss); // marks the mapping as lost; the first loss is kept
// Counts the mappings that are lost and still watched.
[[nodiscard]] std::size_t lost_mapping_count();

} // namespace server::store
