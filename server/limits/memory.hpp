// Counts the memory that is held for clients and datasets, and keeps all of it below one total.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>

namespace ciel::limits {

enum class Held {
    scenes,   // documents of sessions and their histories
    surfaces, // query state and surfaces of scenes
    answers,  // of calls under way: files, pictures, texts of batches
    unsent    // frames and answers that a socket has not taken yet
};
inline constexpr std::array held_names{"scenes", "surfaces", "answers", "unsent"};

// Thread-safe. Must outlive its charges.
class Memory {
public:
    // dataset_bytes: what all datasets have in memory now. release: gives back datasets that nobody uses. Both are
    // called from charging threads and must not charge.
    Memory(std::uint64_t most_bytes, std::function<std::uint64_t()> dataset_bytes, std::function<void()> release);

    // What one holder has, until it is destroyed. Not thread-safe.
    class Charge {
    public:
        Charge(Memory& memory, Held held) : memory_(memory), held_(held) {}
        ~Charge() { note(0); }
        Charge(const Charge&) = delete;
        Charge& operator=(const Charge&) = delete;

        // Before the memory is taken. Throws LimitReached and keeps the old figure where the total would be passed.
        void change(std::size_t bytes);
        void note(std::size_t bytes); // of what is there already: never refused
        [[nodiscard]] std::size_t bytes() const { return bytes_; }

    private:
        Memory& memory_;
        Held held_;
        std::size_t bytes_ = 0;
    };

    // The sentence for a client whose request does not fit.
    [[nodiscard]] std::string refusal() const;
    [[nodiscard]] std::uint64_t room() const;
    [[nodiscard]] std::uint64_t most() const { return most_; }
    [[nodiscard]] std::uint64_t bytes(Held held) const;

private:
    [[nodiscard]] std::uint64_t charged() const;           // REQUIRES: the lock
    [[nodiscard]] bool add(Held held, std::uint64_t more); // false, and nothing is added, where it does not fit
    void add_or_throw(Held held, std::uint64_t more);
    void replace(Held held, std::size_t before, std::size_t after);

    const std::uint64_t most_;
    const std::function<std::uint64_t()> dataset_bytes_;
    const std::function<void()> release_;
    mutable std::mutex mutex_;
    std::array<std::uint64_t, held_names.size()> bytes_{};
};

} // namespace ciel::limits
