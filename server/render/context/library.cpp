#include "render/context/library.hpp"

#include "ciel/types.hpp"

#include <dlfcn.h>

namespace server::render {

Library::Library(const char* name) : name_(name), handle_(dlopen(name, RTLD_NOW | RTLD_LOCAL)) {
    if (handle_ == nullptr) throw ciel::Error(dlerror());
}

void* Library::address(const char* symbol) const {
    void* address = dlsym(handle_, symbol);
    if (address == nullptr) throw ciel::Error(name_ + " lacks the function " + symbol);
    return address;
}

} // namespace server::render
