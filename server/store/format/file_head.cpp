#include "store/format/file_head.hpp"

#include "store/files/files.hpp"
#include "store/format/layout.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <string_view>

namespace server::store {
namespace {

constexpr std::array<std::uint8_t, 8> magic{0x89, 'C', 'I', 'E', 'L', '\r', '\n', 0x1a};

struct Head {
    std::array<std::uint8_t, 8> magic{};
    FileKind kind{};
    std::uint16_t oldest_reader = 0, writer = 0; // format versions, see store/README.md
    std::array<char, 32> dataset_id{};           // padded with zeros
    std::array<std::uint64_t, 2> reserved{};
};
static_assert(sizeof(Head) == file_head_bytes);

} // namespace

std::array<std::byte, file_head_bytes> file_head(FileKind kind, const std::string& dataset_id) {
    Head head{magic, kind, layout::records_version, layout::records_version, {}, {}};
    if (dataset_id.size() > head.dataset_id.size())
        throw ciel::Error("a dataset's id must not be longer than 32 bytes");
    std::ranges::copy(dataset_id, head.dataset_id.begin());
    return std::bit_cast<std::array<std::byte, file_head_bytes>>(head);
}

void check_file_head(std::span<const std::byte> bytes, FileKind kind, const std::string& dataset_id,
                     const std::filesystem::path& file) {
    Head head;
    if (bytes.size() < sizeof head) refuse_damage(file, "is too short: the first 64 bytes are not complete");
    std::memcpy(&head, bytes.data(), sizeof head);
    if (head.magic != magic || head.kind != kind)
        refuse_damage(file, "does not begin with the bytes that mark this kind of file");
    if (head.oldest_reader > layout::records_version)
        refuse(file, "was written by a newer CIEL, in format " + std::to_string(head.writer) + "; update CIEL");
    const auto& id = head.dataset_id;
    if (std::string_view(id.begin(), std::ranges::find(id, '\0')) != dataset_id)
        refuse_damage(file, "belongs to another dataset");
}

} // namespace server::store
