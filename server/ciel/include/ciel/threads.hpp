// The kernel's stop token and mutex. In WebAssembly, which runs one thread, both do nothing. The parallel loop is in
// parallel.hpp. Not in the paper.
#pragma once

#if !defined(__wasm__)
#include <mutex>
#include <stop_token>
#endif

namespace ciel {

#if defined(__wasm__)
struct StopToken {
    [[nodiscard]] bool stop_requested() const { return false; }
};
struct Mutex {
    void lock() {}
    void unlock() {}
};
#else
using StopToken = std::stop_token;
using Mutex = std::mutex;
#endif

// Holds the mutex until the end of the scope.
class Locked {
public:
    explicit Locked(Mutex& mutex) : mutex_(mutex) { mutex_.lock(); }
    ~Locked() { mutex_.unlock(); }
    Locked(const Locked&) = delete;
    Locked& operator=(const Locked&) = delete;

private:
    Mutex& mutex_;
};

} // namespace ciel
