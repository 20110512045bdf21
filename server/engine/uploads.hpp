// Steps that clients push in pieces: begun, filled, committed.
#pragma once

#include "limits/limits.hpp"
#include "store/append.hpp"
#include "store/loaded.hpp"
#include "wire/upload_piece.hpp"

#include <chrono>
#include <mutex>

namespace ciel::engine {

using wire::UploadId;
[[nodiscard]] std::string to_text(const wire::UploadId& id);                // 32 hexadecimal digits
[[nodiscard]] wire::UploadId upload_id(const std::string& text);            // throws NotFound
[[nodiscard]] std::uint64_t upload_bytes(const store::PlannedArray& array); // float32

struct BegunUpload {
    wire::UploadId id{}; // random: it is all that a piece needs
    store::StepPlan plan;
};

struct CommittedUpload {
    std::string dataset; // by its name in the catalog
    std::shared_ptr<store::LoadedDataset> loaded;
    std::size_t step = 0;
    double time = 0;
};

// Thread-safe. Values wait in nameless files on the dataset's disk. What was silent for upload_idle_seconds is given
// up.
class Uploads {
public:
    using Clock = std::chrono::steady_clock;

    explicit Uploads(const limits::Limits& limits);
    ~Uploads();

    // Checks names, sizes, time, the limits and the free disk before the first piece. Throws LimitReached, Error.
    BegunUpload begin(const std::string& name, const std::shared_ptr<store::LoadedDataset>& loaded, double time,
                      std::vector<store::WantedArray> wanted);
    // Bytes of one array, without a gap behind those that have come; some may come again. Returns how many have come.
    // Throws NotFound, LimitReached, Error; the upload stays as it was.
    std::uint64_t add(const wire::UploadPiece& piece);
    // Writes the step, under the dataset's lock. Throws NotFound, Error; then the upload stays as it was.
    CommittedUpload commit(const wire::UploadId& id);
    void cancel(const wire::UploadId& id); // throws NotFound

    void expire(Clock::time_point now);
    [[nodiscard]] std::size_t count() const;
    [[nodiscard]] std::uint64_t bytes() const; // reserved on disks

private:
    struct Upload;
    [[nodiscard]] std::shared_ptr<Upload> find(const wire::UploadId& id); // counts as a sign of life

    const limits::Limits& limits_;
    mutable std::mutex mutex_;
    std::mutex committing_; // one at a time
    std::map<wire::UploadId, std::shared_ptr<Upload>> open_;
};

} // namespace ciel::engine
