// The kernel's only parallel loop. It uses TBB or std::thread, or runs serially, as chosen at build time
// (CIEL_PARALLEL). Not in the paper, which is serial.
#pragma once

#include <cstddef>
#include <functional>
#include <type_traits>

namespace ciel {

// Non-owning reference to the body of a loop. Unlike a std::function, it allocates no memory for a lambda's captures.
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

// Calls body(begin, end) for disjoint ranges that together cover [0, count). A range has about `grain` items. Several
// ranges run at the same time, on any threads. If a body throws, ranges that have not begun may be skipped.
// parallel_for then rethrows one exception, after all running bodies have returned.
void parallel_for(std::size_t count, std::size_t grain, LoopBody body);

// Returns the largest number of threads that a loop of the calling thread may use.
[[nodiscard]] unsigned thread_count();

// Implements with_threads. REQUIRES: threads > 0.
void run_with_threads(unsigned threads, const std::function<void()>& call);

// Calls call(). The loops in this call use at most `threads` threads, including the calling thread; 0: no limit. If the
// body of a limited loop starts an inner loop, the inner loop runs only on the body's thread. Rethrows what call()
// throws.
template <class Call>
void with_threads(unsigned threads, const Call& call) {
    if (threads == 0) return call();
    run_with_threads(threads, std::cref(call)); // a std::function that holds a reference allocates no memory
}

} // namespace ciel
