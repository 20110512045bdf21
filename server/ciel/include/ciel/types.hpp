// Basic types of the kernel: indices, vectors, cell types, errors. Not in the paper.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

namespace ciel {

using Index = std::uint32_t;
inline constexpr Index none = std::numeric_limits<Index>::max();

using Vec3f = std::array<float, 3>;
using Vec3d = std::array<double, 3>;

// The values are VTK's cell type numbers, which most file formats use.
enum class CellType : std::uint8_t { tetrahedron = 10, hexahedron = 12, wedge = 13, pyramid = 14, polyhedron = 42 };

// The class of all errors that users see. The message is one sentence that names the object at fault and says what to
// do.
class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// Throws Error with this message. A build without exceptions (WebAssembly) prints the message and aborts.
[[noreturn]] void fail(const std::string& sentence);

} // namespace ciel
