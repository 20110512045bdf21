// Writes and reads those binary files of a dataset that are read as a whole. Such a file consists of the head
// (file_head.hpp), arrays at offsets that are stored in the file, and the XXH3-64 checksum of all bytes before the
// checksum.
#pragma once

#include "store/files/files.hpp"
#include "store/format/checksum.hpp"
#include "store/format/file_head.hpp"

#include <cstring>
#include <vector>

namespace server::store {

class ByteWriter {
public:
    ByteWriter(FileKind kind, const std::string& dataset_id) { add(file_head(kind, dataset_id)); }

    template <class T>
    void add(std::span<const T> values) {
        const auto bytes = std::as_bytes(values);
        out_.insert(out_.end(), bytes.begin(), bytes.end());
    }
    template <class T>
    void add(const T& value) {
        add(std::span<const T>(&value, 1));
    }
    [[nodiscard]] std::vector<std::byte> finish() {
        add(checksum_number(out_));
        return std::move(out_);
    }

private:
    std::vector<std::byte> out_;
};

// Does not own the bytes and the path. Both must outlive the reader.
class ByteReader {
public:
    // Throws Error when the head has another kind or dataset id, or when the checksum is wrong.
    ByteReader(std::span<const std::byte> bytes, FileKind kind, const std::string& dataset_id,
               const std::filesystem::path& file)
        : bytes_(bytes), file_(file) {
        check_file_head(bytes, kind, dataset_id, file);
        const auto sum = array<std::uint64_t>(bytes.size() - sizeof(std::uint64_t), 1).front();
        bytes_ = bytes.first(bytes.size() - sizeof sum);
        if (checksum_number(bytes_) != sum) refuse_damage("does not match its checksum");
    }
    // `begin`: offset in bytes. Throws Error when the elements do not lie inside the file.
    template <class T>
    [[nodiscard]] std::vector<T> array(std::uint64_t begin, std::uint64_t count) const {
        if (begin > bytes_.size() || count > (bytes_.size() - begin) / sizeof(T))
            refuse_damage("lists an array that does not fit into the file");
        std::vector<T> out(count);
        if (count > 0) std::memcpy(out.data(), bytes_.data() + begin, count * sizeof(T));
        return out;
    }
    [[noreturn]] void refuse_unknown(const std::string& what) const {
        refuse(file_, "uses " + what + ", which the installed CIEL does not know; update CIEL");
    }
    [[noreturn]] void refuse_damage(const std::string& what) const { store::refuse_damage(file_, what); }

private:
    std::span<const std::byte> bytes_;
    const std::filesystem::path& file_;
};

} // namespace server::store
