// Counts the memory that is held for clients and datasets, and keeps the total below a limit.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>

namespace server::limits {

enum class Held {
    scenes,   // documents of sessions and their histories
    surfaces, // query state and surfaces of scenes
    answers,  // files, pictures and batch texts of running calls
    unsent,   // frames and answers not yet accepted by a socket
    requests, // parsed requests of waiting and running calls
    drawing,  // buffers of the renderers, estimated
    uploads   // values of the uploads that are being stored
};
inline constexpr std::array held_names{"scenes", "surfaces", "answers", "unsent", "requests", "drawing", "uploads"};

// Thread-safe. Must outlive its charges.
class Memory {
public:
    // `dataset_bytes` returns the bytes of all datasets. `release` frees unused datasets and unused fields. Both are
    // called on the thread that changes a Charge, and must not change a Charge themselves.
    Memory(std::uint64_t most_bytes, std::function<std::uint64_t()> dataset_bytes, std::function<void()> release);

    // The bytes counted for one holder. The destructor subtracts them from the total. Not thread-safe.
    class Charge {
    public:
        Charge(Memory& memory, Held held) : memory_(memory), held_(held) {}
        ~Charge() { note(0); }
        Charge(const Charge&) = delete;
        Charge& operator=(const Charge&) = delete;

        // Call this before the allocation. Throws LimitReached and keeps the count if the total would exceed the limit.
        void change(std::size_t bytes);
        void note(std::size_t bytes); // for memory already allocated; never throws LimitReached
        [[nodiscard]] std::size_t bytes() const { return bytes_; }

    private:
        Memory& memory_;
        Held held_;
        std::size_t bytes_ = 0;
    };

    void release() const { release_(); }
    // Returns the error message for a client whose request would exceed the limit.
    [[nodiscard]] std::string refusal() const;
    [[nodiscard]] std::uint64_t room() const;
    [[nodiscard]] std::uint64_t most() const { return most_; }
    [[nodiscard]] std::uint64_t bytes(Held held) const;

private:
    [[nodiscard]] std::uint64_t charged() const; // the caller holds mutex_
    // Adds nothing and returns false if the total would exceed the limit.
    [[nodiscard]] bool add(Held held, std::uint64_t more);
    void add_or_throw(Held held, std::uint64_t more);
    void replace(Held held, std::size_t before, std::size_t after);

    const std::uint64_t most_;
    const std::function<std::uint64_t()> dataset_bytes_;
    const std::function<void()> release_;
    mutable std::mutex mutex_;
    std::array<std::uint64_t, held_names.size()> bytes_{};
};

} // namespace server::limits
