#include "store/files/local_files.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <linux/magic.h>
#include <sys/vfs.h>

namespace server::store {

bool is_on_this_machine(const std::filesystem::path& path) {
    // Values of statfs::f_type, from statfs(2) and from the headers of the file systems.
    constexpr std::array<std::uint32_t, 13> remote{
        0x6969,     // NFS
        0x517b,     // SMB
        0xff534d42, // CIFS
        0xfe534d42, // SMB 2
        0x01021997, // 9P
        0x65735546, // FUSE: sshfs, s3fs and others
        0x0bd00bd0, // Lustre
        0x00c36400, // Ceph
        0x47504653, // GPFS
        0x19830326, // BeeGFS
        0x5346414f, // AFS
        0x73757245, // Coda
        0x61756673, // aufs: a union of file systems, which may be remote
    };
    struct statfs status {};
    if (::statfs(path.c_str(), &status) != 0) return true;
    return std::ranges::find(remote, static_cast<std::uint32_t>(status.f_type)) == remote.end();
}

bool is_in_memory(const std::filesystem::path& folder) {
    struct statfs status {};
    return ::statfs(folder.c_str(), &status) == 0 && status.f_type == TMPFS_MAGIC;
}

} // namespace server::store
