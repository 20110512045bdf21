// Memory kept for the answer that says that there is no memory.
#pragma once

namespace ciel::limits {

// Keeps some megabytes back, and again where they were given away since the last call. The first operator new of the
// process that finds no memory gets them and tries once more; after that std::bad_alloc is thrown as ever, and what
// answers, logs and clears up has the rest of them. Thread-safe.
void keep_memory_in_reserve();

} // namespace ciel::limits
