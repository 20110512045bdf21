// Fuzzes HTTP request targets: decoding, prefix, lookup of static files.
#include "gateway/static_files.hpp"
#include "gateway/target.hpp"

#include <cstdlib>
#include <string_view>

using namespace server::gateway;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const StaticFiles no_files;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const auto target = parse_target(text);
    if (!target) return 0;
    if (!target->path.starts_with('/')) std::abort();
    for (const char c : target->path)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) std::abort();
    const auto below = below_prefix(target->path, "/ciel");
    if (!std::string_view(target->path).ends_with(below)) std::abort();
    if (!below.empty() && below.front() != '/') std::abort();
    if (no_files.find(below) != nullptr) std::abort();
    return 0;
}
