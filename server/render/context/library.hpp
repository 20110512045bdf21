// A shared library opened at run time.
#pragma once

#include <string>

namespace server::render {

// Never closed, because drivers leave thread-local data and exit handlers that point into the library.
class Library {
public:
    explicit Library(const char* name); // throws Error with the message of the dynamic loader
    template <typename Function>
    [[nodiscard]] Function get(const char* symbol) const {
        return reinterpret_cast<Function>(address(symbol));
    }

private:
    [[nodiscard]] void* address(const char* symbol) const; // throws Error when the symbol is missing
    std::string name_;
    void* handle_;
};

} // namespace server::render
