#include "store/files/disk_vector.hpp"

#include "store/files/local_files.hpp"
#include "store/files/scratch_file.hpp"

#include <sys/mman.h>

namespace server::store {
namespace {

bool is_disk(const std::filesystem::path& folder) {
    return !folder.empty() && is_on_this_machine(folder) && !is_in_memory(folder);
}

// The disk space is reserved. Otherwise a write to the mapped memory would raise SIGBUS on a full disk.
void* map_new_file(std::size_t bytes, const std::filesystem::path& folder) {
    try {
        const ScratchFile file(folder, bytes);
        return ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file.descriptor(), 0);
    } catch (const ciel::Error&) {
        return MAP_FAILED;
    }
}

} // namespace

void* map_on_disk(std::size_t bytes, const std::filesystem::path& folder) {
    void* memory = is_disk(folder) ? map_new_file(bytes, folder) : MAP_FAILED;
    if (memory == MAP_FAILED)
        memory = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    return memory;
}

void unmap_from_disk(void* memory, std::size_t bytes) noexcept { ::munmap(memory, bytes); }

} // namespace server::store
