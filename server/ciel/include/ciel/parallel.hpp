// The kernel's only parallel loop: TBB, std::thread or serial, chosen at build time (CIEL_PARALLEL). Not in the paper,
// which is serial.
#pragma once

#include <cstddef>
#include <functional>
#include <type_traits>

namespace ciel {

// Non-owning reference to the body of a loop. Unlike std::function, it allocates no memory for captures.
class LoopBody {
public:
    template <class Body>
    requires(!std::is_same_v<Body, LoopBody>)
        LoopBody(const Body& body) // NOLINT(google-explicit-constructor): lambdas convert implicitly
        : body_(&body), call_([](const void* to_call, std::size_t begin, std::size_t end) {
              (*static_cast<const Body*>(to_call))(begin, end);
          }) {}

    void operator()(std::size_t begin, std::size_t end) const { call_(body_, begin, end); }

private:
    const void* body_;
    void (*call_)(const void*, std::size_t, std::size_t);
};

// Calls body(begin, end) for disjoint ranges that cover [0, count), each of about `grain` items, on any thread. An
// exception thrown by a body reaches the caller after all ranges have ended.
void parallel_for(std::size_t count, std::size_t grain, LoopBody body);

// Returns the largest number of threads of a loop that the caller starts.
[[nodiscard]] unsigned thread_count();

void run_with_threads(unsigned threads, const std::function<void()>& call); // REQUIRES: threads > 0

// Calls call(), whose loops use at most `threads` threads, the caller's included; 0: no limit. The limit holds for this
// call alone. A loop that a body of such a loop starts runs on the thread of that body. Rethrows what call() throws.
template <class Call>
void with_threads(unsigned threads, const Call& call) {
    if (threads == 0) return call();
    run_with_threads(threads, std::cref(call)); // a std::function that holds a reference allocates no memory
}

} // namespace ciel
