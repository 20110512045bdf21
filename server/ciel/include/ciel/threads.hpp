// What the kernel knows of threads beside parallel.hpp: a wish to stop, and a lock. WebAssembly has neither. Not in the
// paper.
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

// Holds it to the end of the scope.
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
