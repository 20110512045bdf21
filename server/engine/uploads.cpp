#include "engine/uploads.hpp"

#include "ciel/printable.hpp"
#include "limits/errors.hpp"
#include "store/files/scratch_file.hpp"
#include "store/imported_copy.hpp"

#include <algorithm>
#include <cstring>
#include <random>

namespace server::engine {

struct Uploads::Upload {
    struct Array {
        std::string name;
        bool doubles = false;
        std::uint64_t begin = 0, bytes = 0, received = 0; // `begin`: offset in the file
    };

    std::string dataset;
    std::shared_ptr<store::LoadedDataset> loaded;
    double time = 0;
    std::vector<store::WantedArray> wanted;
    Clock::time_point heard; // guarded by Uploads::mutex_
    bool is_stored = false;  // a commit is writing the step; guarded by Uploads::mutex_
    std::uint64_t bytes = 0;
    std::uint64_t commit_bytes = 0; // memory for storing the largest array

    std::mutex mutex; // guards `arrays` and `file`
    std::vector<Array> arrays;
    std::optional<store::ScratchFile> file;
};

namespace {

constexpr std::uint64_t documents_bytes = 1 << 20; // upper bound of the metadata that a commit writes, in bytes

wire::UploadId random_id() {
    std::random_device device;
    wire::UploadId id;
    for (std::size_t i = 0; i < id.size(); i += sizeof(std::uint32_t)) {
        const std::uint32_t word = device();
        std::memcpy(&id[i], &word, sizeof word);
    }
    return id;
}

std::uint64_t megabytes(std::uint64_t bytes) { return (bytes + (1 << 20) - 1) >> 20; }

void check_own(const std::string& name, const store::Dataset& dataset) {
    if (!store::input_of_copy(dataset.directory()).empty())
        throw ciel::Error(
            "dataset " + ciel::printable(name) +
            " is a copy that `ciel serve` makes again when the source file changes, so appended steps would be "
            "lost; make a dataset with `ciel import` and serve that dataset");
}

void check_disk(const std::string& name, const store::Dataset& dataset, std::uint64_t needed) {
    std::error_code error;
    const std::uint64_t free = std::filesystem::space(dataset.directory(), error).available;
    if (!error && needed > free)
        throw ciel::Error("the disk of " + ciel::printable(name) + " has " + std::to_string(free >> 20) +
                          " MB free and the step needs " + std::to_string(megabytes(needed)) +
                          " MB while it is uploaded; free some space");
}

// Clients must not learn paths of the server.
std::string without_directory(std::string sentence, const store::Dataset& dataset) {
    const std::string directory = dataset.directory().string();
    const std::string& name = dataset.info().name;
    for (auto at = sentence.find(directory); at != std::string::npos; at = sentence.find(directory, at + name.size()))
        sentence.replace(at, directory.size(), name);
    return sentence;
}

template <class T>
store::Values read_values(const store::ScratchFile& file, std::uint64_t begin, std::uint64_t bytes) {
    std::vector<T> values(bytes / sizeof(T));
    file.read(begin, std::as_writable_bytes(std::span(values)));
    return store::Values(std::move(values));
}

} // namespace

std::string to_text(const wire::UploadId& id) {
    std::string text;
    for (const std::uint8_t byte : id) {
        text += "0123456789abcdef"[byte >> 4];
        text += "0123456789abcdef"[byte & 15];
    }
    return text;
}

wire::UploadId upload_id(const std::string& text) {
    wire::UploadId id{};
    const auto digit = [&](std::size_t at) {
        const char c = text[at];
        return static_cast<unsigned>(c <= '9' ? c - '0' : c - 'a' + 10);
    };
    const bool is_id = text.size() == 2 * id.size() && text.find_first_not_of("0123456789abcdef") == std::string::npos;
    if (!is_id)
        throw limits::NotFound("there is no upload " + ciel::printable(text) +
                               "; append.begin returns the id of an upload");
    for (std::size_t i = 0; i < id.size(); ++i) id[i] = static_cast<std::uint8_t>(digit(2 * i) << 4 | digit(2 * i + 1));
    return id;
}

std::uint64_t upload_bytes(const store::PlannedArray& array) {
    return array.values() * (array.doubles ? sizeof(double) : sizeof(float));
}

Uploads::Uploads(const limits::Limits& limits, limits::Memory& memory) : limits_(limits), memory_(memory) {}
Uploads::~Uploads() = default;

BegunUpload Uploads::begin(const std::string& name, const std::shared_ptr<store::LoadedDataset>& loaded, double time,
                           std::vector<store::WantedArray> wanted) {
    expire(Clock::now());
    auto dataset = loaded->dataset();
    if (auto now = dataset->refreshed()) dataset = std::move(now); // also has steps that were just appended
    check_own(name, *dataset);
    BegunUpload begun{random_id(), store::plan_step(*dataset, time, wanted)};
    const auto upload = std::make_shared<Upload>();
    for (const store::PlannedArray& array : begun.plan.arrays) {
        upload->arrays.push_back({array.info.name, array.doubles, upload->bytes, upload_bytes(array), 0});
        upload->bytes += upload_bytes(array);
        upload->commit_bytes = std::max(upload->commit_bytes, 2 * upload_bytes(array)); // 2 copies: as sent, as stored
    }
    upload->commit_bytes += begun.plan.stored_bytes; // upper bound of the point values that are made of a cell array
    if (upload->bytes > limits_.upload_bytes)
        throw limits::LimitReached("the step has " + std::to_string(megabytes(upload->bytes)) +
                                   " MB; an upload may have at most " + std::to_string(limits_.upload_bytes >> 20) +
                                   " MB; leave out arrays, or start the server with a larger --limit-upload-bytes");
    check_disk(name, *dataset, upload->bytes + begun.plan.stored_bytes + documents_bytes);
    upload->dataset = name;
    upload->loaded = loaded;
    upload->time = time;
    upload->wanted = std::move(wanted);
    upload->heard = Clock::now();
    {
        const std::lock_guard lock(mutex_);
        if (open_.size() >= limits_.uploads)
            throw limits::LimitReached(
                std::to_string(limits_.uploads) +
                " uploads are open already; commit or cancel one of them, or wait until an idle upload is cancelled");
        open_.emplace(begun.id, upload);
    }
    try {
        const std::lock_guard lock(upload->mutex);
        upload->file.emplace(dataset->directory(), upload->bytes);
    } catch (...) {
        const std::lock_guard lock(mutex_);
        open_.erase(begun.id);
        throw;
    }
    return begun;
}

// The caller holds mutex_.
std::shared_ptr<Uploads::Upload> Uploads::known(const wire::UploadId& id) const {
    const auto found = open_.find(id);
    if (found == open_.end())
        throw limits::NotFound("there is no upload " + to_text(id) + "; an upload without a piece for " +
                               std::to_string(limits_.upload_idle_seconds) +
                               " s is cancelled. Call append.begin again");
    return found->second;
}

std::shared_ptr<Uploads::Upload> Uploads::find(const wire::UploadId& id) {
    const auto now = Clock::now();
    expire(now);
    const std::lock_guard lock(mutex_);
    auto upload = known(id);
    upload->heard = now;
    return upload;
}

std::uint64_t Uploads::add(const wire::UploadPiece& piece) {
    if (piece.bytes.size() > limits_.upload_piece_bytes)
        throw limits::LimitReached("a piece of an upload may have at most " +
                                   std::to_string(limits_.upload_piece_bytes) + " bytes; send smaller pieces");
    const auto upload = find(piece.upload);
    const std::lock_guard lock(upload->mutex);
    if (piece.array >= upload->arrays.size())
        throw ciel::Error("the upload has no array " + std::to_string(piece.array) + "; give a number less than " +
                          std::to_string(upload->arrays.size()));
    Upload::Array& array = upload->arrays[piece.array];
    if (piece.offset > array.received)
        throw ciel::Error("array '" + array.name + "' has " + std::to_string(array.received) +
                          " bytes so far; a piece at byte " + std::to_string(piece.offset) +
                          " would leave a gap; send the bytes before the piece first");
    if (piece.bytes.size() > array.bytes - piece.offset)
        throw ciel::Error("array '" + array.name + "' has " + std::to_string(array.bytes) + " bytes; a piece of " +
                          std::to_string(piece.bytes.size()) + " bytes at byte " + std::to_string(piece.offset) +
                          " is too long; end the piece at the end of the array");
    upload->file->write(array.begin + piece.offset, std::as_bytes(piece.bytes));
    array.received = std::max(array.received, piece.offset + piece.bytes.size());
    return array.received;
}

// Keeps an upload from being cancelled. The constructor throws NotFound if the upload was cancelled before.
class Uploads::Storing {
public:
    Storing(Uploads& uploads, const wire::UploadId& id) : uploads_(uploads) {
        const std::lock_guard lock(uploads_.mutex_);
        upload_ = uploads_.known(id);
        upload_->is_stored = true;
    }
    ~Storing() {
        const std::lock_guard lock(uploads_.mutex_);
        upload_->is_stored = false;
    }
    Storing(const Storing&) = delete;
    Storing& operator=(const Storing&) = delete;

private:
    Uploads& uploads_;
    std::shared_ptr<Upload> upload_;
};

CommittedUpload Uploads::commit(const wire::UploadId& id, const BeforeArray& before_array) {
    const auto upload = find(id);
    const std::lock_guard one_at_a_time(committing_);
    const std::lock_guard lock(upload->mutex);
    const Storing storing(*this, id);
    for (const Upload::Array& array : upload->arrays)
        if (array.received < array.bytes)
            throw ciel::Error("array '" + array.name + "' has " + std::to_string(array.received) + " of " +
                              std::to_string(array.bytes) + " bytes; send the rest, then commit");
    limits::Memory::Charge held(memory_, limits::Held::uploads);
    held.change(upload->commit_bytes);
    store::Values values; // values of one array at a time
    const auto values_of = [&](std::size_t i) {
        before_array(i, upload->arrays.size());
        const Upload::Array& array = upload->arrays[i];
        values = {}; // frees memory before the next array is read
        values = array.doubles ? read_values<double>(*upload->file, array.begin, array.bytes)
                               : read_values<float>(*upload->file, array.begin, array.bytes);
        return values;
    };
    const auto dataset = upload->loaded->dataset();
    try {
        const auto done = store::append_step(dataset, upload->time, upload->wanted, values_of);
        const std::lock_guard of_all(mutex_);
        open_.erase(id);
        return {upload->dataset, upload->loaded, done.step, upload->time};
    } catch (const ciel::Error& error) {
        const std::lock_guard of_all(mutex_);
        upload->heard = Clock::now();
        throw ciel::Error(without_directory(error.what(), *dataset));
    }
}

void Uploads::cancel(const wire::UploadId& id) {
    expire(Clock::now());
    const std::lock_guard lock(mutex_);
    if (known(id)->is_stored)
        throw ciel::Error("the upload " + to_text(id) +
                          " is being stored; wait for the answer of append.commit, and cancel the upload if it fails");
    open_.erase(id);
}

void Uploads::expire(Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    std::erase_if(open_, [&](const auto& entry) {
        // A higher use count means that another call is filling or committing the upload.
        return entry.second.use_count() == 1 &&
               now - entry.second->heard >= std::chrono::seconds(limits_.upload_idle_seconds);
    });
}

std::size_t Uploads::count() const {
    const std::lock_guard lock(mutex_);
    return open_.size();
}

std::uint64_t Uploads::bytes() const {
    const std::lock_guard lock(mutex_);
    std::uint64_t bytes = 0;
    for (const auto& [id, upload] : open_) bytes += upload->bytes;
    return bytes;
}

} // namespace server::engine
