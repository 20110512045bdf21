// Keeps the process alive when a file shrinks while it is mapped: the first touch behind its new end raises SIGBUS.
// The handler puts zeros in place of the whole mapping, so that its readers go on with harmless values, and notes that
// it is lost, so that nobody shows what was made of them.
#pragma once

#include <cstddef>

namespace ciel::store {

struct WatchedMapping;

// Watches [data, data + bytes), which mmap returned; the first call installs the handler, which passes on the SIGBUS of
// others. Thread-safe; a returned mapping must be given to unwatch before it is unmapped.
[[nodiscard]] WatchedMapping* watch_mapping(void* data, std::size_t bytes);
void unwatch_mapping(WatchedMapping* mapping);
[[nodiscard]] bool is_lost(const WatchedMapping& mapping);
// Whether any mapping was ever lost: as long as none was, nobody needs to ask for each.
[[nodiscard]] bool any_mapping_lost();

} // namespace ciel::store
