// Time steps that clients upload: an upload is begun, gets the bytes of its arrays in pieces, and is committed.
#pragma once

#include "limits/limits.hpp"
#include "limits/memory.hpp"
#include "store/append.hpp"
#include "store/loaded.hpp"
#include "wire/upload_piece.hpp"

#include <chrono>
#include <functional>
#include <mutex>

namespace server::engine {

using wire::UploadId;
[[nodiscard]] std::string to_text(const wire::UploadId& id);     // 32 hexadecimal digits
[[nodiscard]] wire::UploadId upload_id(const std::string& text); // throws NotFound
[[nodiscard]] std::uint64_t upload_bytes(const store::PlannedArray& array);

struct BegunUpload {
    wire::UploadId id{}; // random, because any client that knows the id can add pieces
    store::StepPlan plan;
};

struct CommittedUpload {
    std::string dataset; // name in the catalog
    std::shared_ptr<store::LoadedDataset> loaded;
    std::size_t step = 0;
    double time = 0;
};

// Uploads is thread-safe. Uploaded values are kept in unnamed files on the disk of the dataset. An upload is dropped if
// no call uses the upload for Limits::upload_idle_seconds.
class Uploads {
public:
    using Clock = std::chrono::steady_clock;

    // `memory` counts the values that a commit stores. `limits` and `memory` must outlive the Uploads.
    Uploads(const limits::Limits& limits, limits::Memory& memory);
    ~Uploads();

    // Checks names, sizes, time, limits and free disk space before the first piece. Throws LimitReached, Error.
    BegunUpload begin(const std::string& name, const std::shared_ptr<store::LoadedDataset>& loaded, double time,
                      std::vector<store::WantedArray> wanted);
    // The piece must begin at or before the end of the received bytes, so that bytes may be sent again. Returns the
    // number of received bytes of the array. Throws NotFound, LimitReached, Error; then the upload is unchanged.
    std::uint64_t add(const wire::UploadPiece& piece);
    // Appends the step to the dataset under the dataset's lock, and ends the upload. Throws NotFound, LimitReached,
    // Error; the upload is then unchanged. Calls `before_array` on this thread before each array is written.
    using BeforeArray = std::function<void(std::size_t written, std::size_t of)>;
    CommittedUpload commit(const wire::UploadId& id, const BeforeArray& before_array);
    void cancel(const wire::UploadId& id); // throws NotFound, and Error while a commit stores the upload

    void expire(Clock::time_point now);
    [[nodiscard]] std::size_t count() const;
    [[nodiscard]] std::uint64_t bytes() const; // disk space reserved for all uploads

private:
    struct Upload;
    class Storing;
    [[nodiscard]] std::shared_ptr<Upload> known(const wire::UploadId& id) const;
    [[nodiscard]] std::shared_ptr<Upload> find(const wire::UploadId& id); // restarts the upload's idle time

    const limits::Limits& limits_;
    limits::Memory& memory_;
    mutable std::mutex mutex_;
    std::mutex committing_; // held by commit(), so that one commit runs at a time
    std::map<wire::UploadId, std::shared_ptr<Upload>> open_;
};

} // namespace server::engine
