// All Errors of the kernel are thrown here. Builds without exceptions (WebAssembly) print the message and abort.
#include "ciel/checked_array.hpp"

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

void refuse_array(const ArrayKeeper* keeper) {
    if (keeper != nullptr) keeper->refuse();
    fail("the mesh is damaged: an index is out of range, or two indices contradict each other; import it again");
}

} // namespace ciel
