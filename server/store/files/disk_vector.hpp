// DiskVector: a std::vector whose large buffers are in files without a name. The system treats such memory as its file
// cache: it may write the memory to the disk and use it for other programs.
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace server::store {

// Smaller buffers are in ordinary memory.
inline constexpr std::size_t least_bytes_on_disk = std::size_t{4} << 20;

// Maps a new file in `folder`. Returns ordinary memory instead if `folder` is empty, has no room, cannot be written to,
// is on another machine or is in memory (local_files.hpp). Throws std::bad_alloc when there is no memory.
[[nodiscard]] void* map_on_disk(std::size_t bytes, const std::filesystem::path& folder);
void unmap_from_disk(void* memory, std::size_t bytes) noexcept;

// All objects are equal, because the size of a buffer tells how it is freed. Copies share the folder's path.
template <class T>
class DiskAllocator {
public:
    using value_type = T;

    DiskAllocator() = default; // ordinary memory
    explicit DiskAllocator(std::filesystem::path folder)
        : folder_(std::make_shared<const std::filesystem::path>(std::move(folder))) {}
    template <class U>
    DiskAllocator(const DiskAllocator<U>& other) noexcept : folder_(other.folder()) {} // NOLINT(*-explicit-*)

    [[nodiscard]] T* allocate(std::size_t count) {
        if (count > std::numeric_limits<std::size_t>::max() / sizeof(T)) throw std::bad_array_new_length();
        const std::size_t bytes = count * sizeof(T);
        if (bytes < least_bytes_on_disk) return std::allocator<T>().allocate(count);
        return static_cast<T*>(map_on_disk(bytes, folder_ ? *folder_ : std::filesystem::path()));
    }
    void deallocate(T* memory, std::size_t count) noexcept {
        if (count * sizeof(T) < least_bytes_on_disk)
            std::allocator<T>().deallocate(memory, count);
        else
            unmap_from_disk(memory, count * sizeof(T));
    }
    [[nodiscard]] const std::shared_ptr<const std::filesystem::path>& folder() const { return folder_; }
    friend bool operator==(const DiskAllocator&, const DiskAllocator&) { return true; }

private:
    std::shared_ptr<const std::filesystem::path> folder_;
};

template <class T>
using DiskVector = std::vector<T, DiskAllocator<T>>;

} // namespace server::store
