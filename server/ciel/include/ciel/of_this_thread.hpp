// One object for each thread, as `thread_local` makes them, but safe when memory runs out: glibc ends the process when
// it cannot register the destructor of a thread_local object. Not in the paper.
#pragma once

#if !defined(__wasm__)
#include <memory>
#include <new>
#include <pthread.h>
#endif

namespace ciel {

// Returns the calling thread's object of the type T. The first call of a thread makes the object; it is destroyed when
// the thread ends. Two callers with the same T get the same object; use a separate type for a separate object. Throws
// std::bad_alloc.
template <class T>
[[nodiscard]] T& of_this_thread() {
#if defined(__wasm__)
    static T object;
    return object;
#else
    static thread_local T* object = nullptr; // a pointer has no destructor
    if (object != nullptr) return *object;
    static const struct Key {
        Key() : failed(pthread_key_create(&key, [](void* made) { delete static_cast<T*>(made); })) {}
        pthread_key_t key{};
        int failed;
    } key;
    auto made = std::make_unique<T>();
    if (key.failed != 0 || pthread_setspecific(key.key, made.get()) != 0) throw std::bad_alloc();
    object = made.release();
    return *object;
#endif
}

} // namespace ciel
