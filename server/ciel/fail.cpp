// One place that throws, for builds that cannot (WebAssembly).
#include "ciel/types.hpp"

#if !defined(__cpp_exceptions)
#include <cstdio>
#include <cstdlib>
#endif

namespace ciel {

void fail(const std::string& sentence) {
#if defined(__cpp_exceptions)
    throw Error(sentence);
#else
    std::fputs((sentence + "\n").c_str(), stderr);
    std::abort();
#endif
}

} // namespace ciel
